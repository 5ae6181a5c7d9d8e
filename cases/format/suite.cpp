#include "cases/format/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <unordered_map>

#include "cases/format/glob.h"
#include "cases/format/reader.h"
#include "cases/format/suggestion.h"

namespace fillrule::format {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".toml";

struct FoundFile {
  std::string path;
  std::string name;  // of its cases, without a sweep's suffix
};

// One file that is to be read, and which of its cases are wanted.
struct Wanted {
  FoundFile file;
  bool all = false;
  std::vector<size_t> selectors;  // patterns that may name cases of this file
};

std::string canonical(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return (error ? path : result).generic_string();
}

std::string name_below(const std::string& path, const std::string& folder) {
  return fs::path(path).lexically_relative(folder).replace_extension().generic_string();
}

bool is_inside(const std::string& path, const std::string& folder) {
  const fs::path relative = fs::path(path).lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

class SuiteLoader {
 public:
  explicit SuiteLoader(const std::string& root) : root_(root), canonical_root_(canonical(root)) {}

  void select(std::span<const std::string> selectors) {
    selectors_ = selectors;
    matched_.assign(selectors.size(), false);
    if (selectors.empty()) select_folder(root_);
    for (size_t i = 0; i < selectors.size(); ++i) select_one(i);
  }

  Suite load(const Preview& preview) {
    std::vector<Result<std::string>> texts;
    for (const Wanted& wanted : wanted_) {
      texts.push_back(read_text(wanted.file.path));
      if (preview && texts.back()) preview(*texts.back());
    }
    for (size_t i = 0; i < wanted_.size(); ++i) load_file(wanted_[i], texts[i]);
    for (size_t i = 0; i < selectors_.size(); ++i) {
      if (!matched_[i]) report_unmatched(selectors_[i]);
    }
    return std::move(suite_);
  }

 private:
  // "." for a bare file name, which has no parent path.
  static std::string folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path().generic_string() : ".";
  }

  void select_one(size_t i) {
    const std::string& selector = selectors_[i];
    for (const fs::path& path : {fs::path(selector), fs::path(root_) / selector}) {
      std::error_code error;
      const fs::file_status status = fs::status(path, error);
      if (!fs::exists(status)) continue;
      matched_[i] = true;
      if (fs::is_directory(status)) {
        select_folder(path.generic_string());
      } else {
        want({path.generic_string(), name_of(path.generic_string(), folder_of(path))}).all = true;
      }
      return;
    }
    for (const FoundFile& file : files_of_root()) {
      const bool whole = glob_matches(selector, file.name);
      if (whole || glob_can_match(selector, file.name + '[')) want(file).selectors.push_back(i);
    }
  }

  void select_folder(const std::string& folder) {
    const std::vector<FoundFile> files = find_files(folder);
    for (const FoundFile& file : files) want(file).all = true;
    std::error_code error;
    if (files.empty() && fs::is_directory(folder, error)) {
      suite_.errors.push_back(
          Error{.file = folder, .what = "no case files in this folder", .hint = "case files end in .toml"});
    }
  }

  // The name of a file's cases: its path below the root, or else below `folder`.
  std::string name_of(const std::string& path, const std::string& folder) const {
    const std::string whole = canonical(path);
    return name_below(whole, is_inside(whole, canonical_root_) ? canonical_root_ : canonical(folder));
  }

  // The case files below a folder, sorted by name; what is hidden is left out.
  std::vector<FoundFile> find_files(const std::string& folder) {
    std::vector<FoundFile> files;
    std::error_code error;
    fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
      const fs::path& path = it->path();
      const bool hidden = path.filename().generic_string().starts_with('.');
      std::error_code ignored;
      const bool is_folder = it->is_directory(ignored);
      if (hidden && is_folder) it.disable_recursion_pending();
      if (hidden || path.extension() != kEnding || is_folder) continue;
      files.push_back({path.generic_string(), name_of(path.generic_string(), folder)});
    }
    if (error) suite_.errors.push_back(Error{.file = folder, .what = "cannot be read: " + error.message()});
    std::sort(files.begin(), files.end(), [](const FoundFile& a, const FoundFile& b) { return a.name < b.name; });
    return files;
  }

  const std::vector<FoundFile>& files_of_root() {
    if (!files_of_root_) files_of_root_ = find_files(root_);
    return *files_of_root_;
  }

  // A file that several selectors name is read once.
  Wanted& want(const FoundFile& file) {
    const auto [place, fresh] = wanted_by_path_.try_emplace(canonical(file.path), wanted_.size());
    if (fresh) wanted_.push_back(Wanted{.file = file});
    return wanted_[place->second];
  }

  void load_file(const Wanted& wanted, const Result<std::string>& text) {
    CaseFile read = text ? parse(*text, wanted.file.path, wanted.file.name) : CaseFile{.errors = {text.error()}};
    const bool bad = !read.errors.empty();
    suite_.errors.insert(suite_.errors.end(), read.errors.begin(), read.errors.end());
    // Nothing is known of the cases of a bad file, so no selector is blamed for it.
    for (const size_t i : wanted.selectors) matched_[i] = matched_[i] || bad;
    for (Case& one : read.cases) {
      bool chosen = wanted.all;
      for (const size_t i : wanted.selectors) {
        if (!glob_matches(selectors_[i], one.name) && !glob_matches(selectors_[i], wanted.file.name)) continue;
        chosen = true;
        matched_[i] = true;
      }
      if (chosen) {
        add(std::move(one));
      } else {
        passed_over_.push_back(one.name);
      }
    }
  }

  void add(Case one) {
    const auto [place, fresh] = file_by_name_.try_emplace(one.name, one.file);
    if (fresh) {
      suite_.cases.push_back(std::move(one));
      return;
    }
    suite_.errors.push_back(Error{.file = one.file,
                                  .what = fmt::format("a second case is named \"{}\"", one.name),
                                  .hint = fmt::format("the first is in {}", place->second)});
  }

  void report_unmatched(const std::string& selector) {
    std::vector<std::string> names = passed_over_;
    std::optional<std::string> near;
    for (const FoundFile& file : files_of_root()) {
      names.push_back(file.name);
      if (file.name.ends_with('/' + selector)) near = file.name;  // only its folder is missing
    }
    if (!near) near = closest(selector, names);
    suite_.errors.push_back(Error{.what = fmt::format("no case, file or folder is named \"{}\"", selector),
                                  .hint = near ? fmt::format("did you mean \"{}\"?", *near)
                                               : "a case is named by its path below the suite's folder, for example "
                                                 "\"coverage/shared_diagonal\"; * matches any text"});
  }

  std::string root_;
  std::string canonical_root_;
  std::span<const std::string> selectors_;
  std::vector<bool> matched_;
  std::vector<Wanted> wanted_;
  std::unordered_map<std::string, size_t> wanted_by_path_;
  std::optional<std::vector<FoundFile>> files_of_root_;
  std::unordered_map<std::string, std::string> file_by_name_;
  std::vector<std::string> passed_over_;
  Suite suite_;
};

}  // namespace

Suite load_suite(const std::string& root, std::span<const std::string> selectors, const Preview& preview) {
  SuiteLoader loader(root);
  loader.select(selectors);
  return loader.load(preview);
}

}  // namespace fillrule::format
