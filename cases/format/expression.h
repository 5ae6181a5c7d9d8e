// Values that depend on variables: expressions over the variables of [sweep], [let] and repeat, in double.
//
// Functions: those of muParser, pi, floor, ceil, mod, ulp and random; cases/README.md describes them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cases/format/number.h"
#include "cases/model/result.h"

namespace fillrule::format {

// The variables of one case and the compiled expressions, which are kept from case to case because the variables of a
// file stay in place while their values change.
class Evaluator {
 public:
  Evaluator();
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
  Evaluator(Evaluator&&) = delete;
  Evaluator& operator=(Evaluator&&) = delete;

  // Why a variable cannot have this name now: no identifier, a function's name, defined already.
  [[nodiscard]] Result<void> check_name(const std::string& name) const;

  // The value of a name from now on. Names that check_name refuses must not be given, but redefining is allowed.
  void define(const std::string& name, double value);
  void define_text(const std::string& name, std::string text);
  void undefine(const std::string& name);

  // A literal or an expression.
  Result<Number> number(std::string_view expression);

  // The text itself, or for "$name" the text variable of that name.
  [[nodiscard]] Result<std::string> text(std::string_view text) const;

  // The names defined now, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::format
