#include "harness/report/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <span>
#include <utility>

#include "harness/images/images.h"
#include "harness/report/picture.h"

namespace fillrule::report {
namespace {

// In the PNG a picture is enlarged until it is at least this wide, as long as that keeps pixels square.
constexpr uint32_t kWantedWidth = 384;
constexpr size_t kLongestStem = 120;

uint32_t scale_for(const Target& target) {
  return std::max(1U, kWantedWidth / std::max(target.width, target.height));
}

Result<void> write_png(const std::string& path, const Picture& picture) {
  static_assert(sizeof(Rgb) == 3);
  const std::span bytes(reinterpret_cast<const uint8_t*>(picture.pixels.data()), picture.pixels.size() * sizeof(Rgb));
  return images::write(path, images::rgb_layout(picture.width, picture.height), bytes);
}

// Channels by name, float32. The samples of a pixel lie side by side, which makes the picture wider.
Result<void> write_exr(const std::string& path, const Case& test_case, const Planes& planes) {
  std::vector<std::string> names{"coverage", "hits", "owner", "front_facing"};
  if (!planes.depth.empty()) names.emplace_back("depth");
  const size_t first_varying = names.size();
  for (const Varying& varying : test_case.varyings) {
    for (uint32_t c = 0; c < varying.components; ++c) names.push_back(fmt::format("{}.{}", varying.name, "xyzw"[c]));
  }
  const size_t channels = names.size();
  std::vector<float> data(planes.hits.size() * channels);
  for (size_t i = 0; i < planes.hits.size(); ++i) {
    float* const pixel = &data[i * channels];
    pixel[0] = planes.hits[i] != 0 ? 1.0F : 0.0F;
    pixel[1] = static_cast<float>(planes.hits[i]);
    pixel[2] = planes.owner[i] == kNoOwner ? -1.0F : static_cast<float>(planes.owner[i]);
    pixel[3] = static_cast<float>(planes.front_facing[i]);
    if (!planes.depth.empty()) pixel[4] = planes.depth[i];
    for (size_t c = first_varying; c < channels; ++c) pixel[c] = planes.varyings[c - first_varying][i];
  }
  const images::Layout layout{
      .width = planes.width * planes.samples, .height = planes.height, .channels = std::move(names)};
  return images::write(path, layout, std::span<const float>(data));
}

}  // namespace

std::string file_stem(const std::string& case_name) {
  std::string stem = case_name;
  for (char& c : stem) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                       std::string_view("-=.,+_").find(c) != std::string_view::npos;
    if (!plain) c = '_';
  }
  // Different names stay different, whatever was replaced or cut off.
  if (stem.size() > kLongestStem || stem != case_name) {
    uint32_t hash = 2166136261U;  // FNV-1a
    for (const char c : case_name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    stem = fmt::format("{}-{:08x}", stem.substr(0, kLongestStem), hash);
  }
  return stem;
}

Result<std::vector<std::string>> write_pictures(const std::string& folder, const Case& test_case,
                                                const run::Drawing& drawing) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(Error{.file = folder, .what = "cannot be made: " + error.message()});
  const Planes* const reference = drawing.reference ? &*drawing.reference : nullptr;
  const ValueRange range = range_of(drawing.candidate, reference);
  std::vector<Picture> pictures{picture_of(test_case, drawing.candidate, range)};
  if (reference != nullptr) pictures.push_back(picture_of(test_case, *reference, range));
  pictures.push_back(difference_picture(test_case, drawing.verdict));

  const std::string stem = (std::filesystem::path(folder) / file_stem(test_case.name)).string();
  std::vector<std::string> paths{stem + ".png", stem + ".candidate.exr"};
  if (auto result = write_png(paths[0], side_by_side(pictures, scale_for(test_case.target))); !result) {
    return tl::unexpected(result.error());
  }
  if (auto result = write_exr(paths[1], test_case, drawing.candidate); !result) return tl::unexpected(result.error());
  if (reference != nullptr) {
    paths.push_back(stem + ".reference.exr");
    if (auto result = write_exr(paths[2], test_case, *reference); !result) return tl::unexpected(result.error());
  }
  return paths;
}

}  // namespace fillrule::report
