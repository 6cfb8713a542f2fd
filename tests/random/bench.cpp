#include "tests/random/bench.hpp"

#include <fmt/format.h>

namespace stepwire::random {

namespace {

unit::Dimension dimension_of(const char* text) {
  return unit::parse_unit(text)->dimension;
}

bool has_none(const unit::Dimension& unit) {
  return unit == unit::Dimension{};
}

std::string vector_text(const Shape& shape, const std::vector<double>& numbers, Index row) {
  std::string text;
  for (Index k = 0; k < shape.columns; ++k)
    text += (k == 0 ? "" : ", ") + digits(numbers[static_cast<std::size_t>(row * shape.columns + k)]);
  return "[" + text + "]";
}

}  // namespace

std::string digits(double value) {
  return fmt::format("{:.4g}", value);
}

std::string list_text(const Shape& shape, const std::vector<double>& numbers) {
  if (shape.size() == 1) return digits(numbers.front());
  if (shape.columns == 1) return vector_text({1, shape.rows}, numbers, 0);
  std::string text;
  for (Index row = 0; row < shape.rows; ++row)
    text += (row == 0 ? "" : ", ") + vector_text(shape, numbers, row);
  return "[" + text + "]";
}

std::string Bench::next_name() {
  return fmt::format("n{}", ++count_);
}

std::string Bench::plain(double value, const unit::Dimension& unit) {
  return has_none(unit) ? digits(value) : digits(value) + " " + unit::si_name(unit);
}

std::string Bench::number(double value, const unit::Dimension& unit) {
  const bool is_parameter = dice.chance(sketch.parameters.empty() ? 0.8 : 0.12);
  if (!is_parameter) return plain(value, unit);
  const std::string name = fmt::format("p{}", sketch.parameters.size() + 1);
  sketch.parameters.push_back({name, plain(value, unit)});
  return dice.chance(0.7) ? "$" + name : "= 0.9*" + name;
}

std::string Bench::literal(const Shape& shape, const unit::Dimension& unit) {
  if (shape.size() == 1) return number(signed_size(), unit);
  std::vector<double> numbers;
  for (Index k = 0; k < shape.size(); ++k) numbers.push_back(signed_size());
  const std::string list = list_text(shape, numbers);
  return has_none(unit) ? list : fmt::format("{{value: {}, unit: {}}}", list, unit::si_name(unit));
}

unit::Dimension Bench::some_unit() {
  static const std::vector<const char*> units{"N", "m", "m/s", "s", "A", "V", "J", "kg"};
  return dice.chance(0.75) ? unit::Dimension{} : dimension_of(dice.of(units));
}

double Bench::some_time() {
  const double most = 0.25 * ticks;
  return step * (2.0 + (most - 2.0) * dice.between(0.0, 1.0) * dice.between(0.0, 1.0));
}

Wire Bench::wire(const Shape& shape) {
  std::vector<Wire> fit;
  for (const Wire& wire : wires) {
    if (wire.shape == shape) fit.push_back(wire);
    if (shape.size() == 1 && wire.shape.size() > 1 && dice.chance(0.3)) {
      const int row = dice.whole(1, static_cast<int>(wire.shape.rows));
      const int column = dice.whole(1, static_cast<int>(wire.shape.columns));
      const std::string element = wire.shape.columns == 1 ? fmt::format("{}.{}", wire.text, row)
                                                          : fmt::format("{}.{}.{}", wire.text, row, column);
      fit.push_back({element, {}, wire.unit});
    }
  }
  if (fit.empty() || dice.chance(0.08)) return source(shape);
  return dice.of(fit);
}

Wire Bench::any_wire(bool may_be_matrix) {
  std::vector<Wire> fit;
  for (const Wire& wire : wires)
    if (may_be_matrix || wire.shape.columns == 1) fit.push_back(wire);
  if (!fit.empty() && !dice.chance(0.1)) return dice.of(fit);
  const bool is_matrix = may_be_matrix && dice.chance(0.25);
  const Index rows = dice.chance(0.5) && !is_matrix ? 1 : dice.whole(2, 4);
  return wire({rows, is_matrix ? dice.whole(2, 3) : 1});
}

Wire Bench::in_unit(const Wire& wire, const unit::Dimension& unit) {
  if (wire.unit == unit) return wire;
  const std::string name = next_name();
  add({name, {{"block", "Gain"}, {"u", wire.text}, {"gain", number(signed_size(), unit / wire.unit)}}});
  wires.push_back({name, wire.shape, unit});
  return wires.back();
}

Wire Bench::source(const Shape& shape) {
  const std::string name = next_name();
  const unit::Dimension unit = some_unit();
  Entry entry{name, {{"block", "Sine"}}};
  if (shape.columns > 1 || dice.chance(0.25)) {
    entry.keys = {{"block", "Constant"}, {"value", literal(shape, unit)}};
  } else {
    entry.keys.push_back({"amplitude", literal(shape, unit)});
    entry.keys.push_back({"frequency", plain(dice.between(1.0, 12.0) / (step * ticks), dimension_of("Hz"))});
    entry.keys.push_back({"phase", digits(dice.between(0.0, 6.0))});
  }
  add(std::move(entry));
  wires.push_back({name, shape, unit});
  return wires.back();
}

}  // namespace stepwire::random
