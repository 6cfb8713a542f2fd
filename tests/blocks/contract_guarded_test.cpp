// Each block on condition: nothing in a block knows of it.
#include <catch2/catch.hpp>

#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

constexpr std::int64_t ticks = 20;

bool writes_files(const BlockType& type) {
  return type.file_output;
}

/// The numbers of a block: outputs, states, diagnostics.
std::vector<double> own_numbers(const run::Executor& run) {
  const plan::PlannedBlock& block = run.plan().blocks[tested_in(run.plan())];
  std::vector<double> numbers;
  for (const auto* slots : {&block.outputs, &block.states, &block.diagnostics})
    for (const plan::SignalSlot& slot : *slots)
      numbers.insert(numbers.end(), run.values() + slot.offset, run.values() + slot.offset + slot.size);
  return numbers;
}

}  // namespace

TEST_CASE("every block that is enabled all the time gives the bits that it gives without a condition") {
  for (const BlockType* type : library().types()) {
    if (writes_files(*type)) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      const auto plain = plan_of(wiring), enabled = plan_of(guarded(wiring, "1"));
      if (!plain) continue;
      INFO(wiring.text);
      REQUIRE(enabled);
      run::Executor one(*plain), other(*enabled);
      for (std::int64_t tick = 0; tick < ticks && one.healthy(); ++tick) {
        one.evaluate();
        other.evaluate();
        INFO(tick);
        REQUIRE(same_bits(own_numbers(one), own_numbers(other)));
        one.advance();
        other.advance();
        REQUIRE(one.healthy() == other.healthy());
      }
    }
  }
}

TEST_CASE("no number of a block that is off changes, and its states begin anew where they are reset") {
  for (const BlockType* type : library().types()) {
    if (writes_files(*type)) continue;
    const Wiring wiring = wirings_of(*type).front();
    for (const bool resets : {false, true}) {
      const auto plan = plan_of(guarded(wiring, resets ? "{when: gate, states: reset}" : "gate"));
      INFO(wiring.text << resets);
      REQUIRE(plan);
      run::Executor run(*plan);
      std::vector<double> before;
      for (std::int64_t tick = 0; tick < ticks && run.healthy(); ++tick) {
        run.evaluate();
        INFO(tick);
        // The last tick at which it is active changes the states that its first tick off has.
        if (tick % 5 == 4) REQUIRE(same_bits(before, own_numbers(run)));
        if (tick % 5 == 3) before = own_numbers(run);
        run.advance();
      }
    }
  }
}
