#include "cases/format/reader.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "cases/format/sections.h"
#include "cases/format/siblings.h"
#include "cases/format/sweep.h"

namespace fillrule::format {
namespace {

struct LetVariable {
  std::string name;
  const toml::node* value;
};

class FileReader {
 public:
  FileReader(const toml::table& root, std::string_view text, const std::string& file)
      : root_(root), text_(text), diagnostics_(file), values_(evaluator_, diagnostics_) {}

  CaseFile read(const std::string& name) {
    check_keys({root_, "the case file"},
               {"title", "why", "spec", "origin", "tags", "control", "expect", "opt_out", "target", "state",
                "varyings", "let", "sweep", "draw", "scene"},
               diagnostics_);
    Case head{.file = diagnostics_.file()};
    read_head(root_, diagnostics_, head);
    const Sweep sweep = read_sweep(root_, text_, evaluator_, diagnostics_);
    const Siblings siblings = read_siblings(root_, text_, sweep, diagnostics_);
    read_let(sweep);
    // A case with an error ends the expansion: the others of the file have mostly the same. Where the head or the
    // sweep is wrong, one case is still read for its errors.
    CaseFile result;
    for (size_t i = 0; i < sweep.size(); ++i) {
      const size_t errors_before = diagnostics_.count();
      Case expanded = read_case(head, sweep, i);
      if (!diagnostics_.empty()) {
        if (i > 0) diagnostics_.name_case(errors_before, sweep.suffix(i));
        return CaseFile{.errors = diagnostics_.take()};
      }
      expanded.name = name + sweep.suffix(i);
      siblings.apply(name, sweep, i, expanded);
      result.cases.push_back(std::move(expanded));
    }
    return result;
  }

 private:
  void read_let(const Sweep& sweep) {
    const toml::node* const node = root_.get("let");
    const toml::table* const table = node == nullptr ? nullptr : as_table(*node, "let", diagnostics_);
    if (table == nullptr) return;
    sweep.define(0, evaluator_);
    for (const Entry& entry : in_file_order(*table)) {
      if (const auto good = evaluator_.check_name(entry.name()); !good) {
        diagnostics_.add(place_of(*entry.key), good.error());
        continue;
      }
      let_.push_back({entry.name(), entry.value});
    }
  }

  Case read_case(const Case& head, const Sweep& sweep, size_t index) {
    sweep.define(index, evaluator_);
    for (const LetVariable& variable : let_) {
      // 0 where the expression is wrong, so that its users are not errors as well.
      evaluator_.define(variable.name, values_.number(*variable.value, variable.name).value_or(Number{}).value);
    }
    Case expanded = head;
    expanded.target = read_target(root_, values_);
    RasterState state = default_state(expanded.target);
    const toml::node* const scene_node = root_.get("scene");
    Scene scene;
    if (scene_node != nullptr) {
      scene = read_scene(*scene_node, values_);
      state.depth_test = scene.order == DrawOrder::kDepthBuffer;
    }
    if (const toml::node* const node = root_.get("state")) {
      const toml::table* const table = as_table(*node, "state", diagnostics_);
      if (table != nullptr) read_state({*table, "[state]"}, expanded.target, values_, state);
    }
    if (scene_node != nullptr) {
      for (const char* const key : {"varyings", "draw"}) refuse_beside_scene(key);
      scene.state = state;
      expanded.scene = std::make_shared<const Scene>(std::move(scene));
      return expanded;
    }
    expanded.varyings = read_varyings(root_, values_);
    expanded.draws = read_draws(root_, expanded.target, expanded.varyings, state, values_);
    return expanded;
  }

  // The scene's models have their own.
  void refuse_beside_scene(const char* key) {
    const toml::node* const node = root_.get(key);
    if (node == nullptr) return;
    diagnostics_.add(place_of(*node), fmt::format("\"{}\" beside [scene]", key),
                     "a scene's geometry and varyings come from its models");
  }

  const toml::table& root_;
  std::string_view text_;
  Diagnostics diagnostics_;
  Evaluator evaluator_;
  Values values_;
  std::vector<LetVariable> let_;
};

}  // namespace

CaseFile parse(std::string_view text, const std::string& file_label, const std::string& name) {
  try {
    const toml::table root = toml::parse(text);
    return FileReader(root, text, file_label).read(name);
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    return CaseFile{.errors = {Error{.file = file_label,
                                     .line = place.line,
                                     .column = static_cast<uint32_t>(place.column),
                                     .what = std::string(error.description())}}};
  }
}

Result<std::string> read_text(const std::string& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  // A folder opens, but does not read.
  if (stream) stream.peek();
  if (!stream && !stream.eof()) {
    const std::string reason = std::generic_category().message(errno == 0 ? EIO : errno);
    return tl::unexpected(Error{.file = path, .what = "cannot be read: " + reason});
  }
  stream.clear();
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

CaseFile read_file(const std::string& path, const std::string& name) {
  const Result<std::string> text = read_text(path);
  if (!text) return CaseFile{.errors = {text.error()}};
  return parse(*text, path, name);
}

}  // namespace fillrule::format
