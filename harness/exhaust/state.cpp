#include "harness/exhaust/state.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace fillrule::exhaust {
namespace {

using Json = nlohmann::ordered_json;

// FNV-1a, 64 bits: tells builds apart.
uint64_t hash_of_file(const std::string& path) {
  uint64_t hash = 0xCBF29CE484222325U;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 65536> buffer{};
  while (file.read(buffer.data(), buffer.size()) || file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      const auto byte = static_cast<unsigned char>(buffer[static_cast<size_t>(i)]);
      hash = (hash ^ byte) * 0x100000001B3U;
    }
  }
  return hash;
}

Json party_json(const Party& party) {
  return {{"name", party.name}, {"version", party.version}, {"subpixel_bits", party.subpixel_bits}};
}

Json tally_json(const Tally& tally) {
  return {{"triangles", tally.triangles},
          {"faults", tally.faults},
          {"latitude", tally.latitude},
          {"ties", tally.ties},
          {"strays", tally.strays}};
}

Tally tally_from(const Json& json) {
  return {.triangles = json.at("triangles"),
          .faults = json.at("faults"),
          .latitude = json.at("latitude"),
          .ties = json.at("ties"),
          .strays = json.at("strays")};
}

Json findings_json(const Findings& findings) {
  Json first = Json::array();
  for (const Difference& difference : findings.first) {
    first.push_back({{"number", difference.number},
                     {"vertices", difference.vertices},
                     {"expected", difference.expected},
                     {"drawn", difference.drawn},
                     {"tally", tally_json(difference.tally)}});
  }
  return {{"tally", tally_json(findings.tally)}, {"first", std::move(first)}};
}

Findings findings_from(const Json& json) {
  Findings findings{.tally = tally_from(json.at("tally"))};
  for (const Json& one : json.at("first")) {
    findings.first.push_back({.number = one.at("number"),
                              .vertices = one.at("vertices"),
                              .expected = one.at("expected"),
                              .drawn = one.at("drawn"),
                              .tally = tally_from(one.at("tally"))});
  }
  return findings;
}

Error error_of(const std::string& path, const std::string& what) {
  return {.file = path, .what = what};
}

}  // namespace

std::string identity_of(const Options& options, const Parties& parties) {
  const Json json{{"grid", options.world.grid},
                  {"size", options.world.size},
                  {"triples", options.world.triples == Triples::kOrdered ? "ordered" : "unordered"},
                  {"cull_mode", options.cull_mode},
                  {"target_size", options.target_size},
                  {"candidate", party_json(parties.candidate)},
                  {"reference", parties.reference ? party_json(*parties.reference) : Json()},
                  {"program", hash_of_file("/proc/self/exe")}};
  return json.dump();
}

Result<void> save_state(const std::string& path, const std::string& identity, const Progress& progress) {
  const Json json{{"identity", identity},
                  {"triangles", progress.triangles},
                  {"covering", progress.covering},
                  {"seconds", progress.seconds},
                  {"candidate", findings_json(progress.candidate)},
                  {"reference", findings_json(progress.reference)}};
  std::error_code error;
  const std::filesystem::path file(path);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  const std::string unfinished = path + ".new";
  {
    std::ofstream stream(unfinished, std::ios::binary);
    stream << json.dump(1) << '\n';
    stream.close();
    if (!stream) return tl::unexpected(error_of(unfinished, "cannot be written"));
  }
  std::filesystem::rename(unfinished, file, error);
  if (error) return tl::unexpected(error_of(path, "cannot be written: " + error.message()));
  return {};
}

Result<std::optional<Progress>> load_state(const std::string& path, const std::string& identity) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  try {
    const Json json = Json::parse(stream);
    if (json.at("identity") != identity) {
      return tl::unexpected(error_of(path, "is of another world, other parties or another build"));
    }
    return Progress{.triangles = json.at("triangles"),
                    .covering = json.at("covering"),
                    .candidate = findings_from(json.at("candidate")),
                    .reference = findings_from(json.at("reference")),
                    .seconds = json.at("seconds")};
  } catch (const Json::exception& exception) {
    return tl::unexpected(error_of(path, std::string("is no state file: ") + exception.what()));
  }
}

}  // namespace fillrule::exhaust
