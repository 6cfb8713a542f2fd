#include "tests/random/smooth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace stepwire::random {

namespace {

constexpr std::uint64_t one_in = 7, remainder = 3;

using Names = std::set<std::string>;

/// Blocks whose outputs have as many derivatives as their inputs.
const Names& continuous() {
  static const Names names{"Clock",
                           "Constant",
                           "Cross",
                           "Demux",
                           "Derivative",
                           "Dot",
                           "Gain",
                           "Integrator",
                           "Lag",
                           "Mass",
                           "MatrixGain",
                           "MatrixMultiply",
                           "Multisine",
                           "Mux",
                           "PID",
                           "Polynomial",
                           "Product",
                           "Reshape",
                           "Rotate",
                           "Select",
                           "Sine",
                           "Slice",
                           "StateSpace",
                           "Sum",
                           "TransferFunction",
                           "Transpose",
                           "Trig",
                           "Concatenate",
                           "TransportDelay",
                           "Stack"};
  return names;
}

const Names& sampled() {
  static const Names names{
      "Delay",         "DiscreteIntegrator", "DiscreteStateSpace", "DiscreteTransferFunction",
      "MovingAverage", "SavitzkyGolay",      "UnitDelay",          "ZeroOrderHold"};
  return names;
}

double number_of(const Sketch& sketch, const char* key) {
  for (const Key& one : sketch.head)
    if (one.name == key) return std::stod(one.value);
  return 0.0;
}

bool is_whole(double number) {
  return std::abs(number - std::round(number)) < 1e-6;
}

/// Where edges are no instants, those of sources and of the past have to be at ticks.
bool is_between_ticks(const Entry& entry, double step) {
  for (const char* key : {"time", "period", "delay"}) {
    const std::string* value = entry.find(key);
    if (value && value->find('$') == std::string::npos && value->find('=') == std::string::npos &&
        !is_whole(std::stod(*value) / step))
      return true;
  }
  return false;
}

std::string why_not_smooth(const Sketch& sketch, double step, bool locates) {
  for (const Entry& entry : sketch.blocks) {
    const std::string* type = entry.find("block");
    if (!type) continue;
    if (sampled().contains(*type) && !entry.find("every")) return *type + " keeps to each step";
    if (!may_be_smooth(*type) && *type != "Step" && *type != "Pulse") return *type + " may bend";
    if (!locates && is_between_ticks(entry, step)) return *type + " jumps between ticks";
  }
  for (const auto& [file, part] : sketch.parts)
    if (std::string why = why_not_smooth(part, step, locates); !why.empty()) return why;
  return "";
}

}  // namespace

bool is_smooth(std::uint64_t seed) {
  return seed % one_in == remainder;
}

bool is_continuous(std::uint64_t seed) {
  return seed % (2 * one_in) == remainder;
}

std::uint64_t rank_among_others(std::uint64_t seed) {
  return seed - (seed + remainder) / one_in;
}

bool may_be_smooth(const std::string& type) {
  return continuous().contains(type) || sampled().contains(type);
}

bool may_be_continuous(const std::string& type) {
  return continuous().contains(type) && type != "TransportDelay";
}

bool bends(const std::string& parameter) {
  static const Names names{"lower", "upper",   "integral_lower", "integral_upper",
                           "hold",  "between", "trigger",        "longest"};
  return names.contains(parameter);
}

double some_steps(Bench& bench, int least, int most) {
  if (bench.locates && bench.dice.chance(0.5)) return bench.dice.between(least, most);
  return bench.dice.whole(least, most);
}

Wire edges_on_ticks(Bench& bench) {
  const std::string name = bench.next_name();
  const auto time = [&](double steps) { return digits(bench.step * steps) + " s"; };
  const std::string value = digits(bench.signed_size());
  if (bench.dice.chance(0.5)) {
    bench.add(
        {name, {{"block", "Step"}, {"time", time(some_steps(bench, 1, bench.ticks / 2))}, {"after", value}}});
  } else {
    const double width = some_steps(bench, 2, 8);
    const int parts = bench.dice.of(std::vector<int>{2, 4, 5});
    bench.add({name,
               {{"block", "Pulse"},
                {"amplitude", value},
                {"period", time(width * parts)},
                {"width", digits(1.0 / parts)}}});
  }
  bench.wires.push_back({name, {}, {}});
  return bench.wires.back();
}

std::string why_not_smooth(const Sketch& sketch) {
  const bool locates = std::ranges::find(sketch.head, "events", &Key::name) != sketch.head.end();
  return why_not_smooth(sketch, number_of(sketch, "step"), locates);
}

}  // namespace stepwire::random
