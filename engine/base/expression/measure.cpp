#include "engine/base/expression/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/expression/fold.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::expression {
namespace {

/// An intermediate value: its inferred unit, and the value of a bare number, which may be an exponent.
struct Piece {
  Measure measure;
  bool bare = false;
  std::optional<double> number{};
  bool has_offset = false;     ///< true for a number in degC or degF
  bool is_difference = false;  ///< true for a number in delta_degC or delta_degF
};

const Piece truth{{unit::Dimension{}, true}};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<double> folded(const Operation& operation, const std::vector<Piece>& values) {
  if (!operation.value) return std::nullopt;
  std::vector<double> numbers;
  for (const Piece& value : values) {
    if (!value.number) return std::nullopt;
    numbers.push_back(*value.number);
  }
  return operation.value(numbers.data(), static_cast<int>(numbers.size()));
}

using Zeros = std::optional<double>;

Zeros zeros_of(const Piece& piece) {
  return piece.measure.dimension ? piece.measure.dimension->zeros : std::nullopt;
}

/// Returns the dimension of a value times a bare number. Cycles are dropped, as is the angle where the
/// dimension has a time: the factor may be 2 pi rad per period.
unit::Dimension scaled(unit::Dimension dimension, const Zeros& zeros, const std::optional<double>& by,
                       bool divided) {
  dimension.cycles = 0.0;
  if (dimension.exponents[2] != 0.0) dimension.angle = 0.0;
  if (zeros && by && *by != 0.0) dimension.zeros = divided ? *zeros / *by : *zeros * *by;
  return dimension;
}

class MakeMeasure {
 public:
  explicit MakeMeasure(const std::vector<Measure>& variables) : variables_(variables) {}

  Piece variable(std::size_t i) const { return {variables_[i]}; }

  Piece number(const Program::Number& number) const {
    if (!number.dimension) return {{}, true, number.value};
    const bool is_difference = number.dimension->zeros && *number.dimension->zeros == 0.0;
    return {{number.dimension, true}, false, {}, number.has_offset, is_difference};
  }

  Piece operation(const Operation& operation, const std::vector<Piece>& values, std::size_t place) const {
    const Binding binding = operation.binding;
    if (!operation.value) return of_matrices(operation.name, values);
    if (binding == Binding::atom) return call(operation.name, values, place);
    if (binding == Binding::either || binding == Binding::both || operation.name == "!") return truth;
    Piece result = unit_of(operation, values, place);
    result.number = folded(operation, values);
    return binding == Binding::comparison ? truth : result;
  }

  Piece choice(const Piece&, const Piece& a, const Piece& b) const {
    refuse_meanings(a, b, "? :", 0);
    static_cast<void>(join(a, b, "? :", 0));
    Piece joined = a.bare ? b : a;
    const bool differ = !a.bare && !b.bare && a.measure.dimension != b.measure.dimension;
    if (differ) joined.measure = {};
    return joined;
  }

 private:
  static Piece unit_of(const Operation& operation, const std::vector<Piece>& values, std::size_t place) {
    const Piece& a = values.front();
    if (operation.binding == Binding::prefix) return negative(a);
    if (operation.binding == Binding::product) {
      if (operation.name == "/") refuse_divisor(values[1], place);
      refuse_factor(a, values[1], place);
      return product(operation.name, a, values[1]);
    }
    if (operation.binding == Binding::power) {
      require_pure_number("the exponent of '^'", values[1], place);
      return to_the(a, values[1]);
    }
    if (operation.binding == Binding::comparison) refuse_meanings(a, values[1], operation.name, place);
    Piece joined = join(a, values[1], operation.name, place);
    if (operation.binding == Binding::sum && mix_rates(a, values[1]))
      refuse_meanings(a, values[1], operation.name, place);
    if (operation.binding == Binding::sum && joined.measure.dimension)
      joined.measure.dimension->zeros =
          unit::joined_zeros(zeros_of(a), zeros_of(values[1]), operation.name == "-");
    return joined;
  }

  static Piece negative(const Piece& value) {
    Piece result{value.measure, value.bare};
    if (const Zeros zeros = zeros_of(value)) result.measure.dimension->zeros = -*zeros;
    return result;
  }

  /// True for the sum of an angle per time and a number of periods per time. A sum of temperatures of
  /// different meaning is allowed: a temperature plus a difference.
  static bool mix_rates(const Piece& a, const Piece& b) {
    const auto &x = a.measure.dimension, &y = b.measure.dimension;
    return x && y && *x == *y && unit::mixes_rates(*x / *y);
  }

  /// Refuses a number in degC as a divisor: 1 degC is 274.15 K.
  static void refuse_divisor(const Piece& divisor, std::size_t place) {
    if (divisor.has_offset)
      throw ExpressionError(
          "the number in degC or degF behind '/' is a temperature above absolute zero; write "
          "a difference in K or delta_degC, and a temperature in K",
          place);
  }

  /// Refuses the product or quotient of a temperature and a factor of differences, such as 3 W/degC.
  static void refuse_factor(const Piece& a, const Piece& b, std::size_t place) {
    const auto &x = a.measure.dimension, &y = b.measure.dimension;
    if (!x || !y) return;
    const std::string left = unit::refused_product(x->zeros, *y);
    const std::string refused = left.empty() ? unit::refused_product(y->zeros, *x) : left;
    if (!refused.empty())
      throw ExpressionError(
          fmt::format("the value {} the sign {}", left.empty() ? "after" : "before", refused), place);
  }

  static void refuse_meanings(const Piece& a, const Piece& b, std::string_view sign, std::size_t place) {
    if (a.bare || b.bare || !a.measure.sure || !b.measure.sure) return;
    const unit::Dimension &x = *a.measure.dimension, &y = *b.measure.dimension;
    std::string other = unit::other_meaning(y, x);
    const auto& [given, wanted] = other.empty() ? std::pair(x, y) : std::pair(y, x);
    if (other.empty()) other = unit::other_meaning(x, y);
    const std::string cure = unit::mixes_rates(x / y) ? "; " + unit::cure_of_rate(given, wanted) : "";
    if (!other.empty())
      throw ExpressionError(fmt::format("a value beside '{}' {}{}", sign, other, cure), place);
  }

  /// Returns the unit of a matrix function. All elements of a matrix share one unit, or it is unknown.
  static Piece of_matrices(std::string_view function, const std::vector<Piece>& values) {
    if (is_one_of(function, {"transpose", "norm", "trace"})) return {values[0].measure, values[0].bare};
    if (is_one_of(function, {"rank", "size"})) return truth;
    if (function == "inv") return to_the(values[0], {{}, true, -1.0});
    if (is_one_of(function, {"eye", "zeros", "ones"})) return {{}, true};
    return is_one_of(function, {"[]", "diag"}) ? common(values) : Piece{};
  }

  /// Returns the common unit of all values that are not bare numbers; unknown where two differ.
  static Piece common(const std::vector<Piece>& values) {
    Piece all = values[0];
    for (const Piece& one : values) {
      if (all.bare) all = one;
      if (one.bare) continue;
      if (one.measure.dimension != all.measure.dimension) return {};
      all.measure.sure = all.measure.sure && one.measure.sure;
    }
    return {all.measure, all.bare};
  }

  static Piece call(std::string_view function, const std::vector<Piece>& values, std::size_t place) {
    const Piece& first = values.front();
    if (is_one_of(function, {"min", "max", "mod", "hypot", "atan2"})) {
      Piece all = first;
      for (std::size_t i = 1; i < values.size(); ++i) {
        refuse_meanings(all, values[i], function, place);
        all = join(all, values[i], function, place);
      }
      return function == "atan2" ? truth : all;
    }
    if (is_one_of(function, {"sign", "uniform", "normal", "lognormal"})) return truth;
    if (function == "abs") return {first.measure, first.bare};
    if (function == "sqrt") return to_the(first, {{}, true, 0.5});
    if (function == "cbrt") return to_the(first, {{}, true, 1.0 / 3.0});
    if (!is_one_of(function, {"floor", "ceil", "round"}))  // these allow every unit
      require_pure_number(fmt::format("'{}'", function), first, place);
    return of_a_pure_number(first);
  }

  /// Returns the unit of values that must have one unit, as in a sum, a comparison or min().
  static Piece join(const Piece& a, const Piece& b, std::string_view sign, std::size_t place) {
    if (a.bare && b.bare) return {{}, true};
    if (a.bare || b.bare) return {known_for_sure(a.bare ? b.measure : a.measure)};
    const Measure &x = a.measure, &y = b.measure;
    const bool differ = x.dimension != y.dimension;
    if (differ && x.sure && y.sure)
      throw ExpressionError(fmt::format("'{}' joins {} and {}; they must have the same unit", sign,
                                        unit::si_name(*x.dimension), unit::si_name(*y.dimension)),
                            place);
    if (differ) return {beside_unknown(x, y)};
    return {{x.dimension, x.sure || y.sure}};
  }

  /// Returns the unit of two values if one is unknown: a value without a unit, added to metres, is in metres.
  /// Two different units give an unknown one.
  static Measure beside_unknown(const Measure& x, const Measure& y) {
    if (!x.dimension && y.sure) return y;
    if (!y.dimension && x.sure) return x;
    return {};
  }

  /// Returns the unit where it is sure, else an unknown one: "3 + 10*current" may well be a force.
  static Measure known_for_sure(const Measure& measure) { return measure.sure ? measure : Measure{}; }

  static Piece product(std::string_view sign, const Piece& a, const Piece& b) {
    if (a.bare && b.bare) return a;
    const auto one = [](const Piece& piece) {
      return piece.bare ? unit::Dimension{} : piece.measure.dimension;
    };
    const auto x = one(a), y = one(b);
    if (!x || !y) return {};
    unit::Dimension unit = sign == "*" ? *x * *y : *x / *y;
    const bool of_difference = (a.is_difference && !zeros_of(b)) || (b.is_difference && !zeros_of(a));
    if (unit.exponents[4] != 0.0 && !unit::is_temperature(unit) && of_difference) unit.per_difference = true;
    if (unit::is_temperature(unit) && (x->per_difference || y->per_difference)) unit.zeros = 0.0;
    const bool sure = a.measure.sure && b.measure.sure;
    if (b.bare) return {{scaled(unit, zeros_of(a), b.number, sign == "/"), sure}};
    return {{a.bare ? scaled(unit, zeros_of(b), a.number, false) : unit, sure}};
  }

  static Piece to_the(const Piece& a, const Piece& b) {
    if (a.bare) return {{}, true, folded(*find_operator("^"), {a, b})};
    const auto& dimension = a.measure.dimension;
    if (dimension == unit::Dimension{}) return {a.measure};
    if (!dimension || !b.number) return {};
    return {{unit::power(*dimension, *b.number), a.measure.sure}};
  }

  /// Throws ExpressionError where a pure number is needed and the value has a unit such as a length. Times
  /// are allowed, see of_a_pure_number().
  static void require_pure_number(std::string_view what, const Piece& value, std::size_t place) {
    const Measure& measure = value.measure;
    if (value.bare || !measure.sure || !measure.dimension) return;
    if (*measure.dimension == unit::Dimension{} || *measure.dimension == unit::Dimension{{0, 0, 1}}) return;
    throw ExpressionError(
        fmt::format("{} takes a pure number, and this one is in {}; divide it by a value of that unit", what,
                    unit::si_name(*measure.dimension)),
        place);
  }

  /// Returns the unit of a function of a pure number. Of a value with a unit it is unknown: "exp(-time)"
  /// implies a time constant of one second.
  static Piece of_a_pure_number(const Piece& value) {
    const Measure& measure = value.measure;
    if (value.bare || measure.dimension == unit::Dimension{}) return {{unit::Dimension{}, measure.sure}};
    return {};
  }

  const std::vector<Measure>& variables_;
};

}  // namespace

Measure measure_of(const Program& program, const std::vector<Measure>& variables) {
  return fold<Piece>(program, MakeMeasure(variables)).measure;
}

}  // namespace stepwire::expression
