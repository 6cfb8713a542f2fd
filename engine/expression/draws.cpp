#include "engine/expression/draws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "engine/expression/expression.hpp"
#include "engine/expression/fold.hpp"
#include "engine/expression/function.hpp"
#include "engine/expression/language.hpp"

namespace stepwire {
namespace {

struct Complaint {
  std::string text;
  std::size_t place = 0;
};

/// A value on the way, where it is known, and the first draw that it rests on and that is wrong.
struct Drawn {
  std::optional<double> value;
  std::optional<Complaint> wrong{};
};

double applied(std::string_view sign, double a, double b) {
  if (sign == "+") return a + b;
  if (sign == "-") return a - b;
  if (sign == "*") return a * b;
  if (sign == "/") return a / b;
  if (sign == "^") return std::pow(a, b);
  if (sign == "<") return a < b;
  if (sign == ">") return a > b;
  if (sign == "<=") return a <= b;
  if (sign == ">=") return a >= b;
  if (sign == "==") return a == b;
  if (sign == "!=") return a != b;
  return sign == "&&" ? a != 0.0 && b != 0.0 : a != 0.0 || b != 0.0;
}

class MakeDrawn {
 public:
  MakeDrawn(const Program& program, std::span<const std::optional<double>> values)
      : program_(program), values_(values) {}

  Drawn variable(std::size_t i) const { return {values_[i]}; }
  Drawn number(std::size_t i) const { return {program_.numbers[i]}; }

  Drawn sign(std::string_view sign, const Drawn& a) const {
    if (!a.value) return a;
    return {sign == "-" ? -*a.value : *a.value == 0.0 ? 1.0 : 0.0, a.wrong};
  }

  Drawn operation(std::string_view sign, Binding, const Drawn& a, const Drawn& b, std::size_t) const {
    const bool decided = (sign == "&&" && a.value == 0.0) || (sign == "||" && a.value && *a.value != 0.0);
    if (decided) return {sign == "&&" ? 0.0 : 1.0, a.wrong};
    Drawn result{std::nullopt, a.wrong ? a.wrong : b.wrong};
    if (a.value && b.value) result.value = applied(sign, *a.value, *b.value);
    return result;
  }

  Drawn choice(const Drawn& condition, const Drawn& a, const Drawn& b) const {
    if (condition.wrong) return {std::nullopt, condition.wrong};
    if (!condition.value) return {std::nullopt, a.wrong ? a.wrong : b.wrong};
    return *condition.value != 0.0 ? a : b;
  }

  Drawn call(std::string_view function, const std::vector<Drawn>& drawn, std::size_t place) const {
    Drawn result;
    std::vector<double> known;
    for (const Drawn& one : drawn) {
      if (!result.wrong) result.wrong = one.wrong;
      if (one.value) known.push_back(*one.value);
    }
    if (function == "uniform" || function == "lognormal") check(function, drawn, place, result);
    if (known.size() == drawn.size()) result.value = call_function(function, known);
    return result;
  }

 private:
  static void check(std::string_view function, const std::vector<Drawn>& drawn, std::size_t place,
                    Drawn& result) {
    for (const std::size_t i : {0, 1}) {
      const auto& value = drawn[i].value;
      if (result.wrong || !value || language::is_whole(*value)) continue;
      result.wrong = Complaint{
          fmt::format("'{}' draws by a {} that is a whole number, and {} is none; round(...) makes one",
                      function, i == 0 ? "seed" : "stream", *value),
          place};
    }
    if (function != "lognormal" || result.wrong || !drawn[2].value || !(*drawn[2].value < 0.0)) return;
    result.wrong = Complaint{
        fmt::format("'lognormal' takes a standard deviation, and {} is below 0", *drawn[2].value), place};
  }

  const Program& program_;
  std::span<const std::optional<double>> values_;
};

}  // namespace

void check_draws(const Program& program, std::span<const std::optional<double>> values) {
  if (program.code.find("uniform(") == std::string::npos &&
      program.code.find("lognormal(") == std::string::npos)
    return;
  const MakeDrawn make(program, values);
  if (const Drawn result = Fold<Drawn, MakeDrawn>(program, make).run(); result.wrong)
    throw ExpressionError(result.wrong->text, result.wrong->place);
}

}  // namespace stepwire
