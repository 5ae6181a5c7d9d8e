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

void write_state(const RasterState& state, Writer& out) {
  const VkViewport& viewport = state.viewport;
  const VkRect2D& scissor = state.scissor;
  out.line("\n[draw.state]");
  out.line("cull_mode = \"{}\"", enum_name(kCullModes, state.cull_mode));
  out.line("front_face = \"{}\"", enum_name(kFrontFaces, state.front_face));
  out.line("depth_test = {}", state.depth_test);
  out.line("depth_write = {}", state.depth_write);
  out.line("depth_compare = \"{}\"", enum_name(kCompareOps, state.depth_compare));
  out.line("viewport = {{ x = {}, y = {}, width = {}, height = {}, min_depth = {}, max_depth = {} }}",
           format_float32(viewport.x), format_float32(viewport.y), format_float32(viewport.width),
           format_float32(viewport.height), format_float32(viewport.minDepth), format_float32(viewport.maxDepth));
  out.line("scissor = {{ x = {}, y = {}, width = {}, height = {} }}", scissor.offset.x, scissor.offset.y,
           scissor.extent.width, scissor.extent.height);
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
  if (draw.indices) out.line("indices = [{}]", fmt::join(*draw.indices, ", "));
  write_state(draw.state, out);
  if (varyings.empty()) return;
  out.line("\n[draw.varyings]");
  const size_t stride = component_count(varyings);
  size_t first_component = 0;
  for (const Varying& varying : varyings) {
    out.line("{} = [", varying.name);
    for (size_t vertex = 0; vertex < draw.positions.size(); ++vertex) {
      out.raw("  ");
      out.floats(&draw.varyings[vertex * stride + first_component], varying.components, varying.components == 1);
      out.raw(",\n");
    }
    out.line("]");
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
    out.line("{} = {{ components = {}, interpolation = \"{}\" }}", varying.name, varying.components,
             enum_name(kInterpolations, varying.interpolation));
  }
  for (const Draw& draw : one.draws) write_draw(draw, one.varyings, out);
  return out.take();
}

}  // namespace fillrule::format
