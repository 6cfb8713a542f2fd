// Rules for what a block declares about time: the times of its jumps, that it never jumps, and what it
// computes at instants only.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/solve/left_of.hpp"
#include "tests/blocks/bench.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

template <class Check>
void for_every_wiring(bool (*has)(const BlockType& type), const Check& check) {
  for (const BlockType* type : library().types()) {
    if (!has(*type)) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      INFO(wiring.text);
      if (const auto plan = plan_of(wiring)) check(*plan, tested_in(*plan));
    }
  }
}

std::vector<double> outputs_at(Bench& bench, double time) {
  bench.time() = time;
  bench.outputs();
  return bench.all_outputs();
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// How far the slope behind a time is from that before it, and the values on both sides.
double change_at(Bench& bench, double time) {
  constexpr double part = 1e-4;
  const auto before = outputs_at(bench, time - part), left = outputs_at(bench, solve::left_of(time, 0.0)),
             right = outputs_at(bench, time), behind = outputs_at(bench, time + part);
  double most = largest_difference(left, right);
  for (std::size_t i = 0; i < left.size(); ++i)
    most = std::max(most, std::abs((behind[i] - right[i]) - (left[i] - before[i])) / part);
  return most;
}

}  // namespace

TEST_CASE("a source jumps or bends where it declares its next edge, and nowhere else") {
  std::size_t edges = 0;
  for_every_wiring(
      [](const BlockType& type) { return type.run_next_edge != nullptr && type.name != "Chirp"; },
      [&](const plan::Plan& plan, std::size_t tested) {
        const BlockType& type = plan.diagram.blocks[tested].type();
        if (type.name == "TransportDelay") return;  // its edges are those of its input
        Bench bench(plan, tested);
        double time = 0.0;
        for (int k = 0; k < 4; ++k) {
          bench.time() = time;
          const double edge = bench.next_edge();
          if (!std::isfinite(edge)) break;
          INFO(type.name << " at " << edge);
          REQUIRE(edge > time);
          CHECK(change_at(bench, edge) > 1e-6);
          const double length = edge - time;
          if (length > 0.01) CHECK(change_at(bench, time + 0.37 * length) < change_at(bench, edge));
          time = edge;
          ++edges;
        }
      });
  CHECK(edges > 5);
}

TEST_CASE("what is declared as smooth does not jump by the time alone") {
  std::size_t sources = 0;
  for_every_wiring(
      [](const BlockType& type) {
        return type.smooth && type.inputs.empty() && !type.clocks.empty() && type.run_outputs;
      },
      [&](const plan::Plan& plan, std::size_t tested) {
        Bench bench(plan, tested);
        ++sources;
        for (int k = 1; k < 4000; ++k) {
          const double time = 0.005 * k;
          CHECK(largest_difference(outputs_at(bench, solve::left_of(time, 0.0)), outputs_at(bench, time)) <
                1e-6);
        }
      });
  CHECK(sources >= 4);
}

TEST_CASE("between instants no reset is seen") {
  std::size_t blocks = 0;
  for_every_wiring(
      [](const BlockType& type) {
        return type.run_outputs_at_instant && type.input("reset") >= 0 && type.state("side") >= 0;
      },
      [&](const plan::Plan& plan, std::size_t tested) {
        const BlockType& type = plan.diagram.blocks[tested].type();
        const auto reset = static_cast<std::size_t>(type.input("reset"));
        Bench bench(plan, tested);
        if (!bench.has(reset)) return;
        INFO(type.name);
        bench.state("side") = -1.0;
        bench.input(reset) = 0.0;
        bench.outputs();
        const auto before = bench.all_outputs();
        bench.input(reset) = 1.0;
        bench.outputs();
        CHECK(same_bits(before, bench.all_outputs()));
        ++blocks;
      });
  CHECK(blocks >= 6);
}
