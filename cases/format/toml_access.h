// How the reader walks the TOML tree: places, types in words, keys in the order of the file, and the checks that
// every table needs.
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cases/format/diagnostics.h"

namespace fillrule::format {

Place place_of(const toml::node& node);
Place place_of(const toml::key& key);

// "a table", "an array", "a string", ...
std::string type_in_words(const toml::node& node);

struct Entry {
  const toml::key* key;
  const toml::node* value;
  [[nodiscard]] std::string name() const { return std::string(key->str()); }
};

// The entries of a table in the order of the file, which toml++ does not keep.
std::vector<Entry> in_file_order(const toml::table& table);

// One table of the file and the name that errors call it by, for instance "[target]".
struct Section {
  const toml::table& table;
  std::string label;
};

// Adds an error for every key that is not among those known.
void check_keys(const Section& section, std::initializer_list<std::string_view> known, Diagnostics& diagnostics);

// "`label` must be <expected>, not <what it is>".
void wrong_type(const toml::node& node, std::string_view label, std::string_view expected, Diagnostics& diagnostics,
                std::string hint = {});

// The node as a table or an array; with an error and null if it is something else.
const toml::table* as_table(const toml::node& node, std::string_view label, Diagnostics& diagnostics);
const toml::array* as_array(const toml::node& node, std::string_view label, std::string_view expected,
                            Diagnostics& diagnostics);

}  // namespace fillrule::format
