// report.html: everything that a run found, in one file that shows it without network, server or other files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/html_case.h"
#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

class HtmlReport {
 public:
  // Beyond so many bytes cases are kept as statistics only, which the page says.
  static constexpr size_t kMostBytes = 20'000'000;

  explicit HtmlReport(size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

  // `index` is the case's place in RunResult::cases. False if there was no room for its planes.
  bool add(size_t index, HtmlCase encoded);
  // Whether another small case may find room: if not, it need not be encoded.
  [[nodiscard]] bool has_room() const;
  // A case without planes: there was no room, or it could not be drawn.
  void add_statistics(size_t index) { without_planes_.push_back(index); }

  // The page. `faults` is the text of faults.json, as `fillrule faults` writes it; none where there is none. It is
  // left out if it is not JSON.
  [[nodiscard]] std::string page(const run::RunResult& result, const run::DeviationReport& deviations,
                                 const std::optional<std::string>& faults) const;

 private:
  struct Block {
    size_t index = 0;
    std::string sentence;
    std::string json;
  };
  [[nodiscard]] const Block* block_of(size_t index) const;

  size_t most_bytes_;
  size_t bytes_ = 0;
  std::vector<Block> blocks_;
  std::vector<size_t> without_planes_;
};

}  // namespace fillrule::report
