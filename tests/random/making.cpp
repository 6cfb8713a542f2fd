#include "tests/random/making.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tests/random/smooth.hpp"
#include "tests/random/values.hpp"

namespace stepwire::random {

namespace {

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// "m" and "n" of "m x n"; the second is empty for a shape of one letter.
std::pair<std::string, std::string> letters_of(std::string shape) {
  std::erase(shape, '+');
  const std::size_t times = shape.find(" x ");
  if (times == std::string::npos) return {shape, ""};
  return {shape.substr(0, times), shape.substr(times + 3)};
}

bool has_period(const BlockType& type) {
  return std::ranges::any_of(type.clocks,
                             [](const ClockSpec& clock) { return clock.bind_period != nullptr; });
}

}  // namespace

std::optional<unit::Dimension> UnitVariables::value(const std::string& text) const {
  const auto expression = diagram::parse_unit_expression(text);
  if (!expression || expression->any) return std::nullopt;
  unit::Dimension unit = expression->constant;
  for (const auto& [name, exponent] : expression->variables) {
    const auto known = known_.find(name);
    if (known == known_.end()) return std::nullopt;
    unit = unit * unit::power(known->second, exponent);
  }
  return unit;
}

void UnitVariables::take(const std::string& text, const unit::Dimension& unit) {
  const auto expression = diagram::parse_unit_expression(text);
  if (!expression || expression->any) return;
  unit::Dimension rest = unit / expression->constant;
  const std::pair<std::string, double>* open = nullptr;
  for (const auto& variable : expression->variables) {
    const auto known = known_.find(variable.first);
    if (known != known_.end())
      rest = rest / unit::power(known->second, variable.second);
    else if (!open)
      open = &variable;
    else
      known_[variable.first] = {};
  }
  if (open) known_[open->first] = unit::power(rest, 1.0 / open->second);
}

void Making::make() {
  choose_period();
  prepare(*this);
  set("block", type.name);
  choose_inputs();
  connect_all();
  give_parameters();
  give_initial_values();
  guard();
  bench.add(entry);
  add_outputs();
}

Index Making::size(const std::string& letter) {
  return shape_of(letter).rows;
}

bool Making::is_known(const std::string& text) const {
  const auto [rows, columns] = letters_of(text);
  const auto known = [&](const std::string& one) { return is_number(one) || shapes.contains(one); };
  return known(rows) && (columns.empty() || known(columns));
}

Shape Making::shape_of(const std::string& text) {
  const auto [rows, columns] = letters_of(text);
  if (is_number(rows) && columns.empty()) return {std::stol(rows), 1};
  if (columns.empty()) {
    const auto known = shapes.find(rows);
    if (known != shapes.end()) return known->second;
    return shapes[rows] = {dice().chance(0.4) ? 1 : dice().whole(1, 3), 1};
  }
  return {shape_of(rows).rows, shape_of(columns).rows};
}

unit::Dimension Making::unit_of(const std::string& text) {
  if (!units.value(text)) units.take(text, bench.some_unit());
  return units.value(text).value_or(unit::Dimension{});
}

void Making::choose_period() {
  period = bench.step;
  if (bench.continuous) return;
  const double probability = type.timing == Timing::discrete ? 0.5 : 0.1;
  const bool has_to = bench.smooth && type.timing == Timing::discrete;
  if (type.has_continuous_state() || (!has_to && !dice().chance(probability))) return;
  period = bench.some_period();
  set("every", digits(period) + " s");
}

void Making::choose_inputs() {
  for (const InputSpec& input : type.inputs)
    if (input.optional && !inputs_are_chosen && dice().chance(0.3) &&
        (!bench.smooth || (input.name == "reset" && !bench.continuous)))
      fed.insert(input.name);
  if (fed.contains("value")) fed.insert("reset");
  for (const auto& [one, other] : {std::pair{"manual", "automatic"}, std::pair{"automatic", "manual"}})
    if (fed.contains(one)) fed.insert(other);
  for (const ParameterSpec& spec : type.parameters)
    if (spec.required && spec.kind == ParameterKind::matrix && !spec.shape.empty()) shape_of(spec.shape);
}

void Making::connect_all() {
  for (const InputSpec& input : type.inputs)
    if (!input.optional || fed.contains(input.name))
      set(input.name, input.list ? connect_list(input) : connect(input));
}

std::string Making::connect(const InputSpec& input) {
  if (bench.smooth && input.name == "reset") return edges_on_ticks(bench).text;
  if (auto promise = promise_for(input)) return *promise;
  const bool is_free = !is_known(input.shape);
  const auto [rows, columns] = letters_of(input.shape);
  const bool matrices = !columns.empty();
  if (!is_free && dice().chance(0.06) && !matrices && !has_special_wire(*this, input)) {
    const Shape shape = dice().chance(0.5) ? Shape{} : shape_of(input.shape);
    const auto unit = units.value(input.unit);
    if (unit && shape_of(input.shape).columns == 1) return bench.literal(shape, *unit);
  }
  return wire_for(input).text;
}

/// A signal of a shape that fits, whose unit fits.
Wire Making::wire_for(const InputSpec& input) {
  if (!is_known(input.shape)) {
    const auto [rows, columns] = letters_of(input.shape);
    const bool is_open = columns.empty() && !shapes.contains(rows);
    const Shape some = bench.any_wire(true).shape;
    if (is_open)
      shapes[rows] = some;
    else if (!shapes.contains(rows))
      shapes[rows] = {some.rows, 1};
    if (!columns.empty() && !shapes.contains(columns) && !is_number(columns))
      shapes[columns] = {some.columns, 1};
  }
  const Shape shape = shape_of(input.shape);
  if (auto special = special_wire(*this, input, shape)) return *special;
  const Wire wire = bench.wire(shape);
  units.take(input.unit, wire.unit);
  const auto unit = units.value(input.unit);
  return unit ? bench.in_unit(wire, *unit) : wire;
}

std::optional<std::string> Making::promise_for(const InputSpec& input) {
  const bool loops = input.feedthrough;
  if (loops && (!bench.solves_loops || !dice().chance(0.1))) return std::nullopt;
  if (!loops && !dice().chance(0.35)) return std::nullopt;
  if (input.shape.find(" x ") != std::string::npos || has_special_wire(*this, input)) return std::nullopt;
  if (!is_known(input.shape)) shapes[input.shape] = bench.any_wire(false).shape;
  if (!units.value(input.unit)) units.take(input.unit, bench.some_unit());
  const std::string text = fmt::format("open{}_", bench.promises.size());
  bench.promises.push_back({text, shape_of(input.shape), units.value(input.unit), loops});
  return text;
}

std::string Making::connect_list(const InputSpec& input) {
  const std::size_t count = list_count(*this, input);
  counts[input.name] = count;
  std::string text;
  unit::Dimension product;
  for (std::size_t i = 0; i < count; ++i) {
    Wire wire = element_of_list(input, i);
    product = product * wire.unit;
    if (!input.multiply_units) {
      units.take(input.unit, wire.unit);
      if (const auto unit = units.value(input.unit)) wire = bench.in_unit(wire, *unit);
    }
    text += (i == 0 ? "" : ", ") + wire.text;
  }
  if (input.multiply_units) units.take(input.unit, product);
  return "[" + text + "]";
}

/// An element of a list: of the shape of all, a number for all elements, or as long as it is.
Wire Making::element_of_list(const InputSpec& input, std::size_t index) {
  const auto [rows, columns] = letters_of(input.shape);
  if (input.shape.starts_with("+") && columns.empty()) {
    const Wire wire = bench.any_wire(false);
    shapes[rows].rows = wire.shape.rows + (index == 0 ? 0 : shapes[rows].rows);
    return wire;
  }
  if (input.shape.find('+') != std::string::npos) {
    const bool beside = input.shape.find("x +") != std::string::npos;
    const std::string &open = beside ? columns : rows, &fixed = beside ? rows : columns;
    Shape shape = index == 0 ? bench.any_wire(true).shape : Shape{1, 1};
    if (index == 0) shapes[fixed] = {beside ? shape.rows : shape.columns, 1};
    (beside ? shape.rows : shape.columns) = shapes[fixed].rows;
    const Index own = beside ? shape.columns : shape.rows;
    shapes[open].rows = own + (index == 0 ? 0 : shapes[open].rows);
    return bench.wire(shape);
  }
  if (index > 0 && dice().chance(0.2)) return bench.wire({});
  if (!is_known(input.shape)) shapes[rows] = bench.any_wire(true).shape;
  const Shape shape = shape_of(input.shape);
  return special_wire(*this, input, shape).value_or(bench.wire(shape));
}

void Making::give_parameters() {
  if (!type.presets.empty() && dice().chance(0.6)) set("preset", dice().of(type.presets).name);
  for (const ParameterSpec& spec : type.parameters) {
    if (has(spec.name) || (bench.smooth && bends(spec.name)) || !may_be_given(*this, spec)) continue;
    const std::string value = value_of(*this, spec);
    if (!value.empty()) set(spec.name, value);
  }
}

void Making::give_initial_values() {
  const auto settable = std::ranges::count_if(type.states, [](const StateSpec& s) { return s.settable; });
  for (const StateSpec& state : type.states) {
    const std::string key = settable == 1 ? "initial" : "initial_" + state.name;
    if (!state.settable || has(key) || type.parameter(key) || !is_known(state.shape) || !dice().chance(0.3))
      continue;
    const Shape shape = shape_of(state.shape);
    const auto unit = units.value(state.unit);
    if (shape.columns == 1)
      set(key, bench.literal(dice().chance(0.5) ? Shape{} : shape, unit.value_or(unit::Dimension{})));
  }
}

void Making::guard() {
  if (!bench.guards || !dice().chance(0.2)) return;
  if (bench.smooth) return guard_at_ticks();
  const std::string condition =
      dice().chance(0.2) ? fmt::format("\"time > {} s\"", digits(bench.some_time()))
                         : fmt::format("\"{} > {}\"", bench.wire({}).text, digits(dice().between(-0.6, 0.6)));
  const char* states = dice().chance(0.5) ? "reset" : "held";
  if (dice().chance(0.6) && type.input("enable") < 0) {
    if (dice().chance(0.3)) return set("enable", condition);
    const char* outputs = dice().chance(0.5) ? "reset" : "held";
    return set("enable", fmt::format("{{when: {}, states: {}, outputs: {}}}", condition, states, outputs));
  }
  if (type.has_continuous_state() || (has_period(type) && !has("every"))) return;
  if (type.input("trigger") >= 0 || has("trigger")) return;
  const std::string edge = dice().of(std::vector<std::string>{"rising", "falling", "either"});
  set("trigger", fmt::format("{{when: {}, edge: {}, states: {}}}", condition, edge, states));
}

void Making::guard_at_ticks() {
  if (type.input("enable") >= 0) return;
  const char* states = dice().chance(0.5) ? "reset" : "held";
  set("enable",
      fmt::format("{{when: \"{} > 0.05\", states: {}, outputs: reset}}", edges_on_ticks(bench).text, states));
}

void Making::add_outputs() {
  const bool is_past = type.name == "TransportDelay";  // whose states change with each step
  for (const StateSpec& state : type.states)
    if (type.output(state.name) < 0 && !(bench.smooth && is_past))
      bench.states.push_back(entry.name + "." + state.name);
  for (const OutputSpec& output : type.outputs) {
    if (!is_known(output.shape)) continue;
    Wire wire{entry.name, shape_of(output.shape), {}};
    if (type.outputs.size() > 1) wire.text += "." + output.name;
    const auto unit = units.value(output.unit);
    if (unit) wire.unit = *unit;
    if (!unit && output.unit != "*") continue;
    if (!unit) {
      wire.unit = bench.some_unit();
      bench.sketch.units.push_back({wire.text, "\"" + unit::si_name(wire.unit) + "\""});
    }
    bench.wires.push_back(wire);
  }
}

}  // namespace stepwire::random
