#include "cases/format/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "cases/format/expression_functions.h"
#include "cases/format/suggestion.h"

namespace fillrule::format {
namespace {

// A name keeps its Variable for the evaluator's life, because compiled expressions point at `number`.
struct Variable {
  double number = 0.0;
  std::optional<std::string> text;  // set: the variable is text
  bool defined = false;
};

struct Compiled {
  mu::Parser parser;
  std::vector<std::pair<std::string, const Variable*>> used;
};

bool is_identifier(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
}

// muParser would let an expression change its variables.
bool has_assignment(std::string_view text) {
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      return true;
    }
  }
  return false;
}

mu::Parser make_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineFun("floor", [](double x) { return std::floor(x); });
  parser.DefineFun("ceil", [](double x) { return std::ceil(x); });
  parser.DefineFun("mod", floored_mod);
  parser.DefineFun("ulp", ulp);
  parser.DefineFun("random", random_unit);
  return parser;
}

}  // namespace

struct Evaluator::State {
  mu::Parser prototype = make_parser();
  std::map<std::string, Variable> variables;
  std::unordered_map<std::string, std::unique_ptr<Compiled>> compiled;

  std::vector<std::string> words() const;
  tl::unexpected<Error> unknown(const std::string& name, std::string_view text) const;
  tl::unexpected<Error> explain(const mu::ParserError& error, const std::string& text) const;
  Result<const Compiled*> compile(const std::string& text);
};

Evaluator::Evaluator() : state_(std::make_unique<State>()) {}
Evaluator::~Evaluator() = default;

Result<void> Evaluator::check_name(const std::string& name) const {
  if (!is_identifier(name)) {
    return failure(fmt::format("\"{}\" is not a variable name", name),
                   "a name has letters, digits and _, and does not begin with a digit");
  }
  if (name == "pi" || name == "nan" || name == "inf" || state_->prototype.GetFunDef().contains(name)) {
    return failure(fmt::format("\"{}\" is taken by expressions", name), "choose another name");
  }
  const auto found = state_->variables.find(name);
  if (found != state_->variables.end() && found->second.defined) {
    return failure(fmt::format("variable \"{}\" is defined already", name), "choose another name");
  }
  return {};
}

void Evaluator::define(const std::string& name, double value) {
  Variable& variable = state_->variables[name];
  variable.number = value;
  variable.text.reset();
  variable.defined = true;
}

void Evaluator::define_text(const std::string& name, std::string text) {
  Variable& variable = state_->variables[name];
  variable.text = std::move(text);
  variable.defined = true;
}

void Evaluator::undefine(const std::string& name) {
  state_->variables[name].defined = false;
}

std::vector<std::string> Evaluator::names() const {
  std::vector<std::string> names;
  for (const auto& [name, variable] : state_->variables) {
    if (variable.defined) names.push_back(name);
  }
  return names;
}

// Everything that an expression may name.
std::vector<std::string> Evaluator::State::words() const {
  std::vector<std::string> words;
  for (const auto& [name, variable] : variables) {
    if (variable.defined && !variable.text) words.push_back(name);
  }
  words.emplace_back("pi");
  for (const auto& function : prototype.GetFunDef()) words.push_back(function.first);
  return words;
}

tl::unexpected<Error> Evaluator::State::unknown(const std::string& name, std::string_view text) const {
  const auto found = variables.find(name);
  if (found != variables.end() && found->second.defined && found->second.text) {
    return failure(fmt::format(R"(variable "{}" is text, not a number, in "{}")", name, text),
                   fmt::format("text variables stand alone where text is expected: \"${}\"", name));
  }
  return failure(fmt::format(R"(unknown name "{}" in expression "{}")", name, text),
                 suggestion(name, words(), "known names"));
}

tl::unexpected<Error> Evaluator::State::explain(const mu::ParserError& error, const std::string& text) const {
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && is_identifier(error.GetToken())) {
    return unknown(error.GetToken(), text);
  }
  std::string message = error.GetMsg();
  if (message.ends_with('.')) message.pop_back();
  return failure(fmt::format("expression \"{}\": {}", text, message));
}

Result<const Compiled*> Evaluator::State::compile(const std::string& text) {
  const auto found = compiled.find(text);
  if (found != compiled.end()) return found->second.get();
  if (has_assignment(text)) {
    return failure(fmt::format("expression \"{}\": a variable cannot be assigned to", text), "compare with ==");
  }
  auto fresh = std::make_unique<Compiled>(Compiled{.parser = prototype});
  // It reorders sums; doubles are to be added as they are written. A copied parser forgets the setting.
  fresh->parser.EnableOptimizer(false);
  for (auto& [name, variable] : variables) {
    if (variable.defined && !variable.text) fresh->parser.DefineVar(name, &variable.number);
  }
  fresh->parser.SetExpr(text);
  for (const auto& used : fresh->parser.GetUsedVar()) {
    const auto variable = variables.find(used.first);
    if (variable == variables.end()) return unknown(used.first, text);
    fresh->used.emplace_back(used.first, &variable->second);
  }
  fresh->parser.Eval();
  if (fresh->parser.GetNumResults() != 1) {
    return failure(fmt::format("expression \"{}\" has several values", text), "the decimal separator is a point");
  }
  return compiled.emplace(text, std::move(fresh)).first->second.get();
}

Result<Number> Evaluator::number(std::string_view expression) {
  const std::string formula(trim(expression));
  if (is_literal(formula)) return parse_literal(formula);
  try {
    const Result<const Compiled*> compiled = state_->compile(formula);
    if (!compiled) return tl::unexpected(compiled.error());
    bool finite_inputs = true;
    for (const auto& [name, variable] : (*compiled)->used) {
      if (!variable->defined || variable->text) return state_->unknown(name, formula);
      finite_inputs = finite_inputs && std::isfinite(variable->number);
    }
    const double value = (*compiled)->parser.Eval();
    if (finite_inputs && !std::isfinite(value)) {
      return failure(fmt::format("expression \"{}\" is {}", formula, std::isnan(value) ? "not a number" : "infinite"),
                     "write nan or inf if that is meant");
    }
    return Number{.value = value};
  } catch (const mu::ParserError& error) {
    return state_->explain(error, formula);
  }
}

Result<std::string> Evaluator::text(std::string_view text) const {
  if (!text.starts_with('$')) return std::string(text);
  const std::string name(text.substr(1));
  const auto found = state_->variables.find(name);
  if (found == state_->variables.end() || !found->second.defined) {
    return failure(fmt::format(R"(unknown variable "{}" in "{}")", name, text),
                   suggestion(name, names(), "known variables"));
  }
  if (!found->second.text) {
    return failure(fmt::format("variable \"{}\" is a number, not text", name),
                   "$ takes the text variables of [sweep]");
  }
  return *found->second.text;
}

}  // namespace fillrule::format
