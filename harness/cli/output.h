// What a run and a merge of runs leave behind for others to read: results.json, JUnit, annotations.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::cli {

struct OutputOptions {
  std::string report_folder;  // each empty where none is wanted
  std::string json_file;
  std::string junit_file;
  std::string annotations;  // "github", "gitlab"
};
// All but the folder, which commands call by names of their own.
void add_output_options(CLI::App& command, OutputOptions& options);

// Where the output of the second and further references goes: DIR becomes DIR/<driver>, FILE.json FILE-<driver>.json.
OutputOptions with_suffix(OutputOptions options, const std::string& suffix);

// Whether everything can be written, before anything is drawn; the folder is made. Otherwise the error is printed.
bool can_write_output(const OutputOptions& options);

// All but the pictures, which are there already. Annotations for GitHub are printed, as it reads them there. False if
// something could not be written; the error is printed.
bool write_output(const OutputOptions& options, const run::RunResult& result, const run::DeviationReport& deviations);

bool print_if_failed(const Result<void>& result);

}  // namespace fillrule::cli
