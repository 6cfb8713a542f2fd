#include "tests/random/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::random {

namespace {

bool has_part(const std::string& name, const char* part) {
  return name.find(part) != std::string::npos;
}

/// A number of the size that such a unit has in a short run.
double usual(Making& making, const ParameterSpec& spec) {
  if (spec.unit == "s") return making.bench.some_time();
  if (spec.unit == "Hz") return making.dice().between(1.0, 10.0) / (making.bench.step * making.bench.ticks);
  return making.bench.size();
}

double with_sign(Making& making, const ParameterSpec& spec, double size) {
  if (has_part(spec.name, "lower") || spec.name == "switch_off") return -size;
  if (has_part(spec.name, "upper") || spec.name == "switch_on" || spec.unit == "s") return size;
  return making.dice().chance(0.3) ? -size : size;
}

/// A number within the declared range.
double number_within(Making& making, const ParameterSpec& spec) {
  const Range& range = spec.range;
  const auto lower = range.at_least ? range.at_least : range.above;
  const auto upper = range.at_most ? range.at_most : range.below;
  const double size = usual(making, spec);
  if (lower && upper) return *lower + (*upper - *lower) * making.dice().between(0.05, 0.95);
  if (lower) return *lower + size;
  if (upper) return *upper - size;
  return with_sign(making, spec, size);
}

double whole_within(Making& making, const ParameterSpec& spec) {
  const double lower = spec.range.at_least.value_or(1.0);
  const double upper = std::min(spec.range.at_most.value_or(lower + 12.0), lower + 12.0);
  return making.dice().whole(static_cast<int>(lower), static_cast<int>(upper));
}

std::string with_unit(const std::string& list, const unit::Dimension& unit) {
  if (unit == unit::Dimension{}) return list;
  return fmt::format("{{value: {}, unit: {}}}", list, unit::si_name(unit));
}

/// One number, or one for each element.
std::string elements_text(Making& making, const ParameterSpec& spec) {
  const unit::Dimension unit = making.unit_of(spec.unit);
  const bool is_known = making.is_known(spec.shape);
  const Shape shape = is_known ? making.shape_of(spec.shape) : Shape{};
  if (shape.size() == 1 || shape.columns > 1 || making.dice().chance(0.5))
    return making.bench.number(number_within(making, spec), unit);
  std::vector<double> numbers;
  for (Index k = 0; k < shape.size(); ++k) numbers.push_back(number_within(making, spec));
  return with_unit(list_text(shape, numbers), unit);
}

std::string vector_text(Making& making, const ParameterSpec& spec) {
  const Shape shape = spec.shape.empty() ? Shape{making.dice().whole(1, 3), 1} : making.shape_of(spec.shape);
  std::vector<double> numbers;
  for (Index k = 0; k < shape.size(); ++k) numbers.push_back(number_within(making, spec));
  std::string list = list_text(shape, numbers);
  return with_unit(shape.size() == 1 ? "[" + list + "]" : list, making.unit_of(spec.unit));
}

std::string matrix_of(Making& making, const ParameterSpec& spec) {
  const Shape shape = spec.shape.empty() ? Shape{2, 2} : making.shape_of(spec.shape);
  return with_unit(matrix_text(making, shape.rows, shape.columns, -1.0, 1.0, 1.0), making.unit_of(spec.unit));
}

std::string generic_value(Making& making, const ParameterSpec& spec) {
  switch (spec.kind) {
    case ParameterKind::number: {
      const double number = number_within(making, spec);
      const unit::Dimension unit = making.unit_of(spec.unit);
      return spec.structural ? Bench::plain(number, unit) : making.bench.number(number, unit);
    }
    case ParameterKind::integer:
      return digits(whole_within(making, spec));
    case ParameterKind::flag:
      return making.dice().chance(0.5) ? "true" : "false";
    case ParameterKind::word:
      return "\"" + making.dice().of(spec.words) + "\"";
    case ParameterKind::per_element:
      return elements_text(making, spec);
    case ParameterKind::vector:
      return vector_text(making, spec);
    case ParameterKind::matrix:
      return matrix_of(making, spec);
    default:
      return "";
  }
}

}  // namespace

std::string matrix_text(Making& making, Index rows, Index columns, double lower, double upper,
                        double beside) {
  std::vector<double> numbers;
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < columns; ++c)
      numbers.push_back(r == c ? making.dice().between(lower, upper)
                               : making.dice().between(-beside, beside));
  std::string text;
  for (Index r = 0; r < rows; ++r) {
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(r * columns);
    const std::string row = list_text({columns, 1}, {first, first + columns});
    text += (r == 0 ? "" : ", ") + (columns == 1 ? "[" + row + "]" : row);
  }
  return "[" + text + "]";
}

std::string value_of(Making& making, const ParameterSpec& spec) {
  const auto special = special_values().find(making.type.name + "." + spec.name);
  if (special != special_values().end()) return special->second(making);
  const std::string value = generic_value(making, spec);
  if (value.empty() && spec.required)
    throw std::logic_error("give a value for " + making.type.name + "." + spec.name + " in special_values()");
  return value;
}

bool may_be_given(const Making& making, const ParameterSpec& spec) {
  if (spec.required) return true;
  Dice& dice = making.bench.dice;
  if (special_values().contains(making.type.name + "." + spec.name)) return true;
  if (spec.unit.find('\'') != std::string::npos && !making.units.value(spec.unit)) return true;
  return dice.chance(0.45);
}

}  // namespace stepwire::random
