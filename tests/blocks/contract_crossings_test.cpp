// Rules for blocks that declare crossings: as many numbers as declared, and a change of sign wherever an
// output jumps or has a bend.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "engine/simulate/solve/event_locator.hpp"
#include "tests/blocks/bench.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

/// True if one of the crossings reads this input.
bool is_read(const BlockType& type, const std::string& input) {
  return std::ranges::any_of(type.crossings, [&](const CrossingSpec& crossing) {
    return std::ranges::find(crossing.inputs, input) != crossing.inputs.end();
  });
}

template <class Check>
void for_every_crossing_block(const Check& check) {
  for (const BlockType* type : library().types()) {
    if (type->crossings.empty()) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      INFO(wiring.text);
      const auto plan = plan_of({"events: locate\n" + wiring.text, wiring.may_be_refused});
      if (!plan) continue;
      const std::size_t tested = tested_in(*plan);
      for (const plan::CrossingCall& call : plan->crossings)
        if (call.block == tested) check(*plan, tested, call.count);
    }
  }
}

}  // namespace

TEST_CASE("a block adds as many crossings as its declaration has rows and its signals elements") {
  std::size_t blocks = 0;
  for_every_crossing_block([&](const plan::Plan& plan, std::size_t tested, std::size_t count) {
    ++blocks;
    const std::vector<double> numbers = Bench(plan, tested).crossings(count);
    for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(std::isnan(numbers[i]) == (i >= count));
  });
  CHECK(blocks > 10);
}

TEST_CASE("where an output jumps or has a bend a crossing has changed its sign") {
  std::size_t bends = 0;
  for_every_crossing_block([&](const plan::Plan& plan, std::size_t tested, std::size_t count) {
    const BlockType& type = plan.diagram.blocks[tested].type();
    if (type.has_continuous_state()) return;  // its output is the solver's
    for (std::size_t i = 0; i < type.inputs.size(); ++i) {
      Bench bench(plan, tested);
      if (!bench.has(i) || !is_read(type, type.inputs[i].name)) continue;
      INFO(type.name << "." << type.inputs[i].name);
      std::vector<double> before = bench.crossings(count);
      double last[2]{};
      int since = 0;  // a change of sign
      for (int k = 0; k < 8000; ++k) {
        bench.input(i) = 3.0 * std::sin(0.00231 * k) + 0.01234;
        since = solve::sign_changes(before.data(), bench.crossings(count).data(), count) ? 0 : since + 1;
        bench.outputs();
        const double y = bench.output(), bend = y - 2.0 * last[0] + last[1];
        if (k > 2 && std::abs(bend) > 1e-3) {
          ++bends;
          CHECK(since <= 2);  // as many steps as the bend is taken of
        }
        last[1] = last[0];
        last[0] = y;
        bench.update();
        before = bench.crossings(count);
      }
    }
  });
  CHECK(bends > 20);
}

TEST_CASE("an output that moves between its crossings does not jump between instants") {
  std::size_t moving = 0;
  for_every_crossing_block([&](const plan::Plan& plan, std::size_t tested, std::size_t) {
    const BlockType& type = plan.diagram.blocks[tested].type();
    if (type.has_continuous_state()) return;  // its output is the solver's
    for (std::size_t i = 0; i < type.inputs.size(); ++i) {
      Bench bench(plan, tested);
      if (!bench.has(i) || !is_read(type, type.inputs[i].name)) continue;
      INFO(type.name << "." << type.inputs[i].name);
      bench.input(i) = 0.01234;
      bench.outputs_at_instant();
      double last = bench.output(), most = 0.0;
      bool moves = false;
      for (int k = 1; k < 3000; ++k) {
        bench.input(i) = 3.0 * std::sin(0.00231 * k) + 0.01234;
        bench.outputs();
        const double change = std::abs(bench.output() - std::exchange(last, bench.output()));
        moves = moves || (change > 0.0 && change < 0.05);
        most = std::max(most, change);
      }
      moving += moves;
      if (moves) CHECK(most < 0.05);
    }
  });
  CHECK(moving > 5);
}
