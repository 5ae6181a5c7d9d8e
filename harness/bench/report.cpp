#include "harness/bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fillrule::bench {

std::string to_json(std::span<const Measurement> measurements) {
  nlohmann::ordered_json workloads = nlohmann::ordered_json::array();
  for (const Measurement& one : measurements) {
    workloads.push_back({{"name", one.name},
                         {"threads", one.threads},
                         {"isa", renderer::to_string(one.isa)},
                         {"renderer_ms", one.renderer.median},
                         {"reference_ms", one.reference.median},
                         {"ratio", one.ratio()}});
  }
  return nlohmann::ordered_json{{"workloads", workloads}}.dump(2) + "\n";
}

std::string to_svg(std::span<const Measurement> measurements) {
  constexpr double kRow = 20;  // pixels
  constexpr double kLabels = 220;
  constexpr double kBars = 400;
  double greatest = 1;
  for (const Measurement& one : measurements) greatest = std::max(greatest, one.ratio());
  const double unit = kBars / greatest;
  const double height = kRow * (static_cast<double>(measurements.size()) + 1);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<text x=\"4\" y=\"14\">times as fast as the reference</text>\n",
      kLabels + kBars + 60, height);
  double y = kRow;
  for (const Measurement& one : measurements) {
    svg += fmt::format(
        "<text x=\"4\" y=\"{0}\">{1}, {2} threads</text><rect x=\"{3}\" y=\"{4}\" width=\"{5:.1f}\" height=\"14\" "
        "fill=\"{6}\"/><text x=\"{7:.1f}\" y=\"{0}\">{8:.2f}</text>\n",
        y + 14, one.name, one.threads, kLabels, y + 3, one.ratio() * unit, one.ratio() < 1 ? "#c66" : "#6a6",
        kLabels + one.ratio() * unit + 4, one.ratio());
    y += kRow;
  }
  svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\" stroke=\"black\"/>\n</svg>\n",
                     kLabels + unit, kRow, height);
  return svg;
}

}  // namespace fillrule::bench
