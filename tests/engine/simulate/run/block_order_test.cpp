// The order of blocks in a file has no part in the results.
#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <random>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

/// A chain of masses with springs and a drive.
const std::vector<std::string> chain{"  push: {block: Sine, amplitude: 3 N, frequency: 2 Hz}",
                                     "  m1: {block: Mass, force: f1, mass: 0.3 kg}",
                                     "  m2: {block: Mass, force: f2, mass: 0.07 kg}",
                                     "  m3: {block: Mass, force: f3, mass: 0.011 kg}",
                                     "  m4: {block: Mass, force: k4, mass: 0.9 kg}",
                                     "  f1: {block: Sum, signs: \"+--\", u: [push, k1, k2]}",
                                     "  f2: {block: Sum, signs: \"++-\", u: [k1, k4, k3]}",
                                     "  f3: {block: Sum, signs: \"++\", u: [k2, k3]}",
                                     "  d12: {block: Sum, signs: \"+-\", u: [m1.position, m2.position]}",
                                     "  d13: {block: Sum, signs: \"+-\", u: [m1.position, m3.position]}",
                                     "  d23: {block: Sum, signs: \"+-\", u: [m2.position, m3.position]}",
                                     "  d4: {block: Sum, signs: \"+-\", u: [m2.position, m4.position]}",
                                     "  k1: {block: Gain, u: d12, gain: 7000 N/m}",
                                     "  k2: {block: Gain, u: d13, gain: 310 N/m}",
                                     "  k3: {block: Gain, u: d23, gain: 47 N/m}",
                                     "  k4: {block: Gain, u: d4, gain: 91 N/m}"};

/// A loop with two equally good tears, and one that is solved at several numbers.
const std::vector<std::string> loops{
    "  wave: {block: Sine, amplitude: 2, frequency: 3 Hz}",
    "  a: {block: Expression, u: [wave, b], expression: u1 - 0.7*tanh(u2)}",
    "  b: {block: Expression, u: [a, c], expression: 0.9*u1 + 0.3*sin(u2)}",
    "  c: {block: Expression, u: [a, b], expression: 0.2*u1 - 0.4*u2}",
    "  d: {block: Expression, u: [b, e, x], expression: 0.3*cos(u2) + u1 - u3}",
    "  e: {block: Expression, u: [d, c], expression: 0.4*u1*u2/(1 + u1^2)}",
    "  x: {block: Lag, u: d, tau: 30 ms}",
    "  y: {block: Lag, u: e, tau: 70 ms}"};

using Columns = std::map<std::string, std::vector<double>>;

Columns columns_of(const std::string& head, const std::vector<std::string>& blocks) {
  std::string text = head + "blocks:\n";
  for (const std::string& block : blocks) text += block + "\n";
  const RunResult result = result_of(text + "record: all\n");
  CHECK(result.faults.empty());
  Columns columns;
  for (const table::Column& column : result.recordings.front().table.columns)
    columns[column.name] = column.values;
  return columns;
}

bool same_bits(const Columns& a, const Columns& b) {
  if (a.size() != b.size()) return false;
  for (const auto& [name, values] : a) {
    const auto other = b.find(name);
    if (other == b.end() || other->second.size() != values.size() ||
        std::memcmp(values.data(), other->second.data(), values.size() * sizeof(double)) != 0)
      return false;
  }
  return true;
}

void compare_orders(const std::string& head, std::vector<std::string> blocks) {
  INFO(head);
  const Columns first = columns_of(head, blocks);
  std::mt19937 random(7);
  for (int order = 0; order < 12; ++order) {
    for (std::size_t i = blocks.size(); i > 1; --i) std::swap(blocks[i - 1], blocks[random() % i]);
    CHECK(same_bits(columns_of(head, blocks), first));
  }
}

}  // namespace

TEST_CASE("the order of blocks in the file changes no bit, with any solver") {
  for (const char* solver : {"rosenbrock", "sdirk", "rk4", "dormand_prince"})
    compare_orders(std::string("step: 5 ms\nstop: 0.4 s\nsolver: ") + solver + "\ntolerance: 1e9\n", chain);
}

TEST_CASE("the order of blocks in the file changes no bit of solved loops") {
  for (const char* solver : {"rosenbrock", "rk4"})
    compare_orders(std::string("step: 5 ms\nstop: 0.2 s\nalgebraic_loops: solve\ntolerance: 1e9\nsolver: ") +
                       solver + "\n",
                   loops);
}

}  // namespace stepwire::run
