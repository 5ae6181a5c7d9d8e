// Renderer and driver side by side: first whether their pictures agree, then how long each takes, in turns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/bench/party.h"
#include "harness/bench/scene.h"
#include "renderer/isa.h"

namespace fillrule::bench {

// In milliseconds.
struct Timing {
  double median = 0;
  double lower_quartile = 0;
  double upper_quartile = 0;
};

// Of sorted or unsorted values; there must be one.
Timing timing_of(std::vector<double> milliseconds);

// How two pictures of a scene differ.
struct PictureDifference {
  uint32_t coverage = 0;  // pixels with another number of covered samples
  uint32_t color = 0;     // others, of which a channel is off by more than kMaxChannelDifference
};
inline constexpr uint32_t kMaxChannelDifference = 3;  // of 255

PictureDifference difference(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b, uint32_t samples);

// The wall's, or how long the process had a processor, which other work on the machine hardly disturbs: a measure of
// what both parties do, not of how well they share it among threads.
enum class Clock : uint8_t { kWall, kProcessor };

struct MeasureOptions {
  uint32_t threads = 1;  // of either party
  renderer::Isa isa = renderer::best_isa();
  uint32_t repetitions = 9;
  Clock clock = Clock::kWall;
  DriverOptions driver;
};

struct Measurement {
  std::string name;
  uint32_t threads = 1;
  renderer::Isa isa{};
  Timing renderer;
  Timing reference;
  PictureDifference difference;

  [[nodiscard]] double ratio() const { return reference.median / renderer.median; }
};

// An error if the coverage differs, or the colour of more than one pixel in a thousand: then no time means anything.
Result<Measurement> measure(const std::string& name, const Scene& scene, const MeasureOptions& options);

}  // namespace fillrule::bench
