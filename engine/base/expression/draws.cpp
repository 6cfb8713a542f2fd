#include "engine/base/expression/draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/fold.hpp"
#include "engine/base/expression/language.hpp"

namespace stepwire::expression {
namespace {

struct Complaint {
  std::string text;
  std::size_t place = 0;
};

/// An intermediate value, if known, and the first invalid draw that it depends on.
struct Drawn {
  std::optional<double> value;
  std::optional<Complaint> wrong{};
};

class MakeDrawn {
 public:
  explicit MakeDrawn(std::span<const std::optional<double>> values) : values_(values) {}

  Drawn variable(std::size_t i) const { return {values_[i]}; }
  Drawn number(const Program::Number& number) const { return {number.value}; }

  Drawn operation(const Operation& operation, const std::vector<Drawn>& values, std::size_t place) const {
    if (is_decided(operation, values[0])) return {*values[0].value != 0.0, values[0].wrong};
    Drawn result;
    std::vector<double> known;
    for (const Drawn& one : values) {
      if (!result.wrong) result.wrong = one.wrong;
      if (one.value) known.push_back(*one.value);
    }
    if (operation.draws() && !result.wrong) result.wrong = complaint(operation.name, values, place);
    if (known.size() == values.size() && operation.value)
      result.value = operation.value(known.data(), static_cast<int>(known.size()));
    return result;
  }

  Drawn choice(const Drawn& condition, const Drawn& a, const Drawn& b) const {
    if (condition.wrong) return {std::nullopt, condition.wrong};
    if (!condition.value) return {std::nullopt, a.wrong ? a.wrong : b.wrong};
    return *condition.value != 0.0 ? a : b;
  }

 private:
  /// True where the first operand alone determines the value of && or ||.
  static bool is_decided(const Operation& operation, const Drawn& first) {
    if (!first.value) return false;
    return operation.binding == (*first.value == 0.0 ? Binding::both : Binding::either);
  }

  static std::optional<Complaint> complaint(std::string_view function, const std::vector<Drawn>& values,
                                            std::size_t place) {
    for (const std::size_t i : {0, 1})
      if (const auto& value = values[i].value; value && !language::is_whole(*value))
        return Complaint{
            fmt::format("'{}' draws by a {} that is a whole number, and {} is none; round(...) makes one",
                        function, i == 0 ? "seed" : "stream", *value),
            place};
    if (function != "lognormal" || !(values[2].value.value_or(0.0) < 0.0)) return std::nullopt;
    return Complaint{
        fmt::format("'lognormal' takes a standard deviation, and {} is below 0", *values[2].value), place};
  }

  std::span<const std::optional<double>> values_;
};

}  // namespace

void check_draws(const Program& program, std::span<const std::optional<double>> values) {
  const auto draws = [](const Instruction& instruction) {
    return instruction.operation && instruction.operation->draws();
  };
  if (std::ranges::none_of(program.code, draws)) return;
  if (const Drawn result = fold<Drawn>(program, MakeDrawn(values)); result.wrong)
    throw ExpressionError(result.wrong->text, result.wrong->place);
}

}  // namespace stepwire::expression
