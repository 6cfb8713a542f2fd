// Parameters whose declaration leaves open what makes a block of use: tables,
// formulas, shapes, charts.
#include <fmt/format.h>

#include <algorithm>

#include "tests/random/value_tools.hpp"

namespace stepwire::random {

namespace {

/// Rising numbers around 0.
std::vector<double> rising(Making& making, int count) {
  std::vector<double> numbers{making.dice().between(-1.5, -0.5)};
  while (static_cast<int>(numbers.size()) < count)
    numbers.push_back(numbers.back() + making.dice().between(0.2, 1.0));
  return numbers;
}

std::string table_points(Making& making) {
  making.shapes["table"] = {making.dice().whole(2, 4), 1};
  return in_unit(making, list(rising(making, static_cast<int>(making.size("table")))), "'u");
}

std::string values_of_table(Making& making) {
  return in_unit(making, list(some(making, making.size("table"))), "'v");
}

template <char axis>
std::string axis_points(Making& making) {
  const std::string letter = fmt::format("axis_{}", axis), variable = fmt::format("'{}", axis);
  making.shapes[letter] = {making.dice().whole(2, 4), 1};
  return in_unit(making, list(rising(making, static_cast<int>(making.size(letter)))), variable.c_str());
}

std::string surface(Making& making) {
  return in_unit(making, matrix_text(making, making.size("axis_r"), making.size("axis_c"), -2.0, 2.0, 2.0),
                 "'v");
}

std::string grid_points(Making& making) {
  std::string text;
  for (std::size_t d = 0; d < making.counts["u"]; ++d)
    text += (text.empty() ? "" : ", ") + list(rising(making, 2 + static_cast<int>(d % 2)));
  return "[" + text + "]";
}

std::string grid_values(Making& making, std::size_t dimension) {
  if (dimension == making.counts["u"]) return digits(making.bench.signed_size());
  std::string text;
  for (std::size_t k = 0; k < 2 + dimension % 2; ++k)
    text += (k == 0 ? "" : ", ") + grid_values(making, dimension + 1);
  return "[" + text + "]";
}

std::string all_grid_values(Making& making) {
  return grid_values(making, 0);
}

/// The last word, which ends a run, is rare.
std::string extrapolation(Making& making) {
  return making.dice().of(
      std::vector<std::string>{"hold", "linear", "hold", "linear", "hold", "linear", "refuse"});
}

std::string order_of_sum(Making& making) {
  std::string signs;
  for (std::size_t k = 0; k < making.counts["u"]; ++k) signs += making.dice().chance(0.5) ? '+' : '-';
  return making.dice().chance(0.5) ? "\"" + signs + "\"" : "";
}

std::string formula(Making& making) {
  static const std::vector<const char*> of_one{"0.5*u1 + 0.1", "sin(u1)",       "u1 > 0.2 ? u1 : -0.5*u1",
                                               "tanh(2*u1)",   "abs(u1) - 0.3", "u1*u1/(1 + u1*u1)",
                                               "exp(-u1*u1)",  "max(u1, 0.1)",  "mod(u1, 0.7)",
                                               "floor(3*u1)"};
  static const std::vector<const char*> of_two{"u1 + 0.4*u2", "atan2(u1, 1 + u2*u2)", "u1 > u2 ? u1 : u2",
                                               "min(u1, u2)", "u1*u2/(2 + u2*u2)",    "hypot(u1, u2)"};
  const std::string text = making.dice().of(making.counts["u"] == 1 ? of_one : of_two);
  const auto& parameters = making.bench.sketch.parameters;
  if (parameters.empty() || parameters.front().value.find(' ') != std::string::npos ||
      !making.dice().chance(0.3))
    return "\"" + text + "\"";
  return fmt::format("\"{} * ({})\"", parameters.front().name, text);
}

std::string kind_of_logic(Making& making) {
  static const std::vector<const char*> words{"and", "or", "nand", "nor", "xor", "xnor"};
  return fmt::format("\"{}\"", making.counts["u"] == 1 ? "not" : making.dice().of(words));
}

std::string rows_of_reshape(Making& making) {
  const Index count = making.shape_of("k").size();
  std::vector<Index> divisors;
  for (Index k = 1; k <= count; ++k)
    if (count % k == 0) divisors.push_back(k);
  const Index rows = making.dice().of(divisors);
  making.shapes["m"] = {rows, 1};
  making.shapes["n"] = {count / rows, 1};
  return fmt::format("{}", rows);
}

std::string indices(Making& making, const char* from, const char* to) {
  std::string text;
  const int count = making.dice().whole(1, 3);
  for (int k = 0; k < count; ++k)
    text +=
        (k == 0 ? "" : ", ") + fmt::format("{}", making.dice().whole(1, static_cast<int>(making.size(from))));
  making.shapes[to] = {count, 1};
  return "[" + text + "]";
}

std::string sizes_of_demux(Making& making) {
  std::string text;
  char letter = 'a';
  for (Index left = making.size("n"); left > 0; ++letter) {
    const Index own = letter == 'h' ? left : making.dice().whole(1, static_cast<int>(left));
    making.shapes[std::string(1, letter)] = {own, 1};
    text += fmt::format("{}{}", text.empty() ? "" : ", ", own);
    left -= own;
  }
  return "[" + text + "]";
}

std::string time_text(double seconds) {
  return fmt::format("{} s", digits(seconds));
}

std::string chart(Making& making) {
  return fmt::format(
      "{{idle: {{output: [{}], to: {{busy: \"after >= {}\"}}}}, busy: "
      "{{output: [{}], history: true, enter: "
      "{{n: n + "
      "1}}, to: {{idle: \"after >= {} || u1 > {}\"}}, states: {{slow: {{to: "
      "{{fast: \"after >= {}\"}}}}, "
      "fast: "
      "{{each: {{n: n + u1}}, to: {{slow: \"after >= {}\"}}}}}}}}}}",
      digits(making.bench.size()), time_text(making.bench.some_time()), digits(making.bench.signed_size()),
      time_text(making.bench.some_time()), digits(making.bench.size()), time_text(making.bench.some_time()),
      time_text(making.bench.some_time()));
}

std::string switches(Making& making) {
  return fmt::format(
      "[{{from: 1, to: 2, when: [{{enter: 1}}, {{after: {}}}]}}, {{from: 2, "
      "to: 1, when: {{leave: 2}}}}, "
      "{{from: 1, to: 2, when: {{pass: [{}, {}], within: 0.1}}}}]",
      time_text(making.bench.some_time()), digits(making.bench.signed_size()), digits(making.bench.size()));
}

std::string region(Making& making) {
  const auto some = [&] { return digits(making.bench.signed_size()); };
  return fmt::format(
      "{{union: [{{center: [{}, {}], radius: {}}}, {{polygon: "
      "[[{}, 0], [2, 0.1], [1.5, {}]]}}]}}",
      some(), some(), digits(making.bench.size()), digits(-making.bench.size()),
      digits(making.bench.size() + 0.3));
}

}  // namespace

namespace {

const std::map<std::string, SpecialValue>& table_values() {
  static const std::map<std::string, SpecialValue> values{
      {"Counter.lower", [](Making&) -> std::string { return "-5"; }},
      {"Counter.upper", whole<2, 9>},
      {"Demux.sizes", sizes_of_demux},
      {"Expression.expression", formula},
      {"Expression.variables", without},
      {"GuidePath.trail", without},
      {"Interlock.causes", without},
      {"Interlock.stop", without},
      {"LayerActivator.initial", whole<1, 2>},
      {"LayerActivator.switches", switches},
      {"Logic.operator", kind_of_logic},
      {"LookupTable.extrapolation", extrapolation},
      {"LookupTable.points", table_points},
      {"LookupTable.values", values_of_table},
      {"LookupTable2D.columns", axis_points<'c'>},
      {"LookupTable2D.extrapolation", extrapolation},
      {"LookupTable2D.rows", axis_points<'r'>},
      {"LookupTable2D.values", surface},
      {"LookupTableND.extrapolation", extrapolation},
      {"LookupTableND.points", grid_points},
      {"LookupTableND.values", all_grid_values},
      {"Polynomial.hold",
       [](Making& m) -> std::string { return m.dice().chance(0.5) ? "" : in_unit(m, "[-1, 1.5]", "'u"); }},
      {"Proportionality.W", [](Making& m) { return digits(-m.bench.size()); }},
      {"Proportionality.points", [](Making&) -> std::string { return "[-0.5, 0.2, 0.8]"; }},
      {"Proportionality.values",
       [](Making& m) { return fmt::format("[0, {}, 2.5]", digits(m.bench.size())); }},
      {"Region.shape", region},
      {"Reshape.columns", without},
      {"Reshape.rows", rows_of_reshape},
      {"Select.indices", [](Making& m) { return indices(m, "n", "m"); }},
      {"Slice.columns", [](Making& m) { return indices(m, "n", "q"); }},
      {"Slice.rows", [](Making& m) { return indices(m, "m", "p"); }},
      {"StateMachine.counters", [](Making&) -> std::string { return "{n: 0}"; }},
      {"StateMachine.initial", without},
      {"StateMachine.states", chart},
      {"StateMachine.variables", without},
      {"Sum.signs", order_of_sum},
      {"Trig.function",
       [](Making& m) -> std::string {
         static const std::vector<std::string> all{"sin", "cos", "atan", "tanh", "tan", "sinh", "cosh"};
         return all[m.dice().below(m.bench.smooth ? 4 : all.size())];
       }},
      {"GuidePath.half_width", without}};
  return values;
}

}  // namespace

const std::map<std::string, SpecialValue>& special_values() {
  static const std::map<std::string, SpecialValue> values = [] {
    std::map<std::string, SpecialValue> all = model_values();
    all.insert(table_values().begin(), table_values().end());
    return all;
  }();
  return values;
}

}  // namespace stepwire::random
