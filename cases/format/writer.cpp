#include "cases/format/writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

#include "cases/format/enums.h"
#include "cases/format/number.h"

namespace fillrule::format {
namespace {

// A TOML basic string.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\u{:04X}", code);
    } else {
      result += c;
    }
  }
  return result + '"';
}

class Writer {
 public:
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  // "[a, b]", or the bare number where there is one and `bare` is set.
  void floats(const float* values, size_t count, bool bare) {
    if (!bare) text_ += '[';
    for (size_t i = 0; i < count; ++i) {
      if (i > 0) text_ += ", ";
      text_ += format_float32(values[i]);
    }
    if (!bare) text_ += ']';
  }

  void raw(std::string_view text) { text_ += text; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void write_head(const Case& one, Writer& out) {
  std::vector<std::string> tags;
  for (const std::string& tag : one.tags) tags.push_back(quoted(tag));
  out.line("title = {}", quoted(one.title));
  out.line("why = {}", quoted(one.why));
  out.line("spec = {}", quoted(one.spec));
  out.line("origin = {}", quoted(one.origin));
  out.line("tags = [{}]", fmt::join(tags, ", "));
  if (!one.control.empty()) out.line("control = {}", quoted(one.control));
  if (one.effect != Effect::kDifferent) out.line("expect = \"{}\"", enum_name(kEffects, one.effect));
  if (one.opt_outs.empty()) return;
  out.line("\n[opt_out]");
  for (const OptOut& opt_out : one.opt_outs) out.line("{} = {}", opt_out.check, quoted(opt_out.reason));
}

void write_target(const Target& target, Writer& out) {
  out.line("\n[target]");
  out.line("size = [{}, {}]", target.width, target.height);
  out.line("depth_format = \"{}\"", enum_name(kDepthFormats, target.depth_format));
  out.line("samples = {}", static_cast<uint32_t>(target.samples));
  out.line("clear_depth = {}", format_float32(target.clear_depth));
}

// What few cases have is written only where it is not the default.
void write_extra_state(const RasterState& state, Writer& out) {
  const RasterState usual;
  if (state.depth_bias) {
    out.line("depth_bias = {{ constant = {}, slope = {}, clamp = {} }}",
             format_float32(state.depth_bias->constant_factor), format_float32(state.depth_bias->slope_factor),
             format_float32(state.depth_bias->clamp));
  }
  if (state.depth_bounds) {
    out.line("depth_bounds = {{ min = {}, max = {} }}", format_float32(state.depth_bounds->min),
             format_float32(state.depth_bounds->max));
  }
  if (state.depth_clamp) out.line("depth_clamp = true");
  if (state.depth_clip == state.depth_clamp) out.line("depth_clip = {}", state.depth_clip);
  if (state.negative_one_to_one) out.line("negative_one_to_one = true");
  if (state.polygon_mode != usual.polygon_mode) {
    out.line("polygon_mode = \"{}\"", enum_name(kPolygonModes, state.polygon_mode));
  }
  if (state.line_mode != usual.line_mode) out.line("line_mode = \"{}\"", enum_name(kLineModes, state.line_mode));
  if (state.line_width != usual.line_width) out.line("line_width = {}", format_float32(state.line_width));
  if (state.provoking_vertex != usual.provoking_vertex) {
    out.line("provoking_vertex = \"{}\"", enum_name(kProvokingVertices, state.provoking_vertex));
  }
  if (state.sample_mask != usual.sample_mask) out.line("sample_mask = {}", state.sample_mask);
}

void write_state(const RasterState& state, Writer& out) {
  const VkViewport& viewport = state.viewport;
  const VkRect2D& scissor = state.scissor;
  out.line("\n[draw.state]");
  out.line("cull_mode = \"{}\"", enum_name(kCullModes, state.cull_mode));
  out.line("front_face = \"{}\"", enum_name(kFrontFaces, state.front_face));
  out.line("depth_test = {}", state.depth_test);
  out.line("depth_write = {}", state.depth_write);
  out.line("depth_compare = \"{}\"", enum_name(kCompareOps, state.depth_compare));
  write_extra_state(state, out);
  out.line("viewport = {{ x = {}, y = {}, width = {}, height = {}, min_depth = {}, max_depth = {} }}",
           format_float32(viewport.x), format_float32(viewport.y), format_float32(viewport.width),
           format_float32(viewport.height), format_float32(viewport.minDepth), format_float32(viewport.maxDepth));
  out.line("scissor = {{ x = {}, y = {}, width = {}, height = {} }}", scissor.offset.x, scissor.offset.y,
           scissor.extent.width, scissor.extent.height);
}

// Some of the floats that each vertex has.
struct Components {
  size_t stride;
  size_t first;
  size_t count;
};

void write_vertices(std::string_view key, const std::vector<float>& values, const Components& components,
                    Writer& out) {
  out.line("{} = [", key);
  for (size_t i = components.first; i < values.size(); i += components.stride) {
    out.raw("  ");
    out.floats(&values[i], components.count, components.count == 1);
    out.raw(",\n");
  }
  out.line("]");
}

void write_indices(const Draw& draw, Writer& out) {
  std::vector<std::string> indices;
  for (const uint32_t index : *draw.indices) {
    const bool restarts = draw.primitive_restart && index == restart_index(draw.index_type);
    indices.push_back(restarts ? "\"restart\"" : fmt::format("{}", index));
  }
  out.line("indices = [{}]", fmt::join(indices, ", "));
  if (draw.index_type != VK_INDEX_TYPE_UINT32) {
    out.line("index_type = \"{}\"", enum_name(kIndexTypes, draw.index_type));
  }
  if (draw.vertex_offset != 0) out.line("vertex_offset = {}", draw.vertex_offset);
  if (draw.primitive_restart) out.line("primitive_restart = true");
}

void write_draw(const Draw& draw, const std::vector<Varying>& varyings, Writer& out) {
  out.line("\n[[draw]]");
  out.line("topology = \"{}\"", enum_name(kTopologies, draw.topology));
  out.line("positions = [");
  for (const ClipPosition& position : draw.positions) {
    out.raw("  ");
    out.floats(position.data(), position.size(), false);
    out.raw(",\n");
  }
  out.line("]");
  if (draw.indices) write_indices(draw, out);
  if (!draw.point_sizes.empty()) {
    write_vertices("point_sizes", draw.point_sizes, {.stride = 1, .first = 0, .count = 1}, out);
  }
  const uint32_t clips = draw.clip_distance_count;
  const uint32_t culls = draw.cull_distance_count;
  if (clips > 0) write_vertices("clip_distances", draw.clip_distances, {clips, 0, clips}, out);
  if (culls > 0) write_vertices("cull_distances", draw.cull_distances, {culls, 0, culls}, out);
  write_state(draw.state, out);
  const size_t stride = vertex_component_count(varyings);
  if (stride == 0) return;
  out.line("\n[draw.varyings]");
  size_t first_component = 0;
  for (const Varying& varying : varyings) {
    if (varying.source != VaryingSource::kVertices) continue;
    write_vertices(varying.name, draw.varyings, {stride, first_component, varying.components}, out);
    first_component += varying.components;
  }
}

}  // namespace

std::string write(const Case& one) {
  Writer out;
  write_head(one, out);
  write_target(one.target, out);
  if (!one.varyings.empty()) out.line("\n[varyings]");
  for (const Varying& varying : one.varyings) {
    if (varying.source != VaryingSource::kVertices) {
      out.line("{} = {{ source = \"{}\" }}", varying.name, enum_name(kVaryingSources, varying.source));
      continue;
    }
    const bool at_center = varying.sampling == Sampling::kCenter;
    out.line("{} = {{ components = {}, interpolation = \"{}\"{} }}", varying.name, varying.components,
             enum_name(kInterpolations, varying.interpolation),
             at_center ? "" : fmt::format(", sampling = \"{}\"", enum_name(kSamplings, varying.sampling)));
  }
  for (const Draw& draw : one.draws) write_draw(draw, one.varyings, out);
  return out.take();
}

}  // namespace fillrule::format
