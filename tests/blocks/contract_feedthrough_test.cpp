// Whether outputs follow inputs at the same instant is declared, and the order of a diagram rests on it.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

/// A moment of a run in which what feeds one input of the tested block can be put to another value.
class FeedthroughBench {
 public:
  explicit FeedthroughBench(const plan::Plan& plan) : plan_(plan), simulation_(plan) {
    for (int tick = 0; tick < 7; ++tick) {
      simulation_.evaluate();
      simulation_.advance();
    }
    kept_ = simulation_.workspace();
  }

  bool healthy() const { return simulation_.healthy(); }

  /// All outputs, with the numbers that feed an input moved by this.
  std::vector<std::vector<double>> outputs(std::size_t input, double by) {
    run::Workspace moved = kept_;
    const diagram::DiagramBlock& tested = plan_.diagram.blocks[tested_in(plan_)];
    for (const diagram::Source& source : tested.inputs[input]) {
      const plan::SignalSlot& state = plan_.blocks[static_cast<std::size_t>(source.block)].states.front();
      for (Eigen::Index k = 0; k < state.size; ++k)
        moved.values[state.offset + static_cast<std::size_t>(k)] += by * static_cast<double>(k + 1);
      by *= 0.5;  // else a difference of inputs would not show it
    }
    simulation_.restore(moved);
    simulation_.evaluate();
    std::vector<std::vector<double>> all;
    for (std::size_t o = 0; o < tested.type().outputs.size(); ++o) all.push_back(output_of(simulation_, o));
    return all;
  }

 private:
  const plan::Plan& plan_;
  run::Executor simulation_;
  run::Workspace kept_;
};

/// By how much inputs are moved: far, little, to the other side, and as far as a sign changes.
constexpr double moves[] = {0.3, -0.3, 2.0, -2.0, 1e-6};

/// Pairs of input and output, "u -> y".
using Pairs = std::map<std::string, bool>;

void look_at(const plan::Plan& plan, Pairs& declared) {
  FeedthroughBench bench(plan);
  if (!bench.healthy()) return;
  const BlockType& type = plan.diagram.blocks[tested_in(plan)].type();
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    if (plan.diagram.blocks[tested_in(plan)].inputs[i].empty()) continue;
    const auto still = bench.outputs(i, 0.0);
    for (double move : moves) {
      const auto moved = bench.outputs(i, move);
      for (std::size_t o = 0; o < type.outputs.size(); ++o) {
        INFO(type.inputs[i].name << " moved by " << move << ": " << type.outputs[o].name);
        const bool follows = !same_bits(moved[o], still[o]);
        if (!feeds_through(plan, i, o)) CHECK_FALSE(follows);
        if (feeds_through(plan, i, o))
          declared[type.inputs[i].name + " -> " + type.outputs[o].name] |= follows;
      }
    }
  }
}

Pairs pairs_of(const BlockType& type) {
  Pairs declared;
  for (const Wiring& wiring : wirings_of(type)) {
    INFO(wiring.text);
    std::optional<plan::Plan> plan;
    REQUIRE_NOTHROW(plan = plan_of(wiring));
    if (plan) look_at(*plan, declared);
  }
  return declared;
}

}  // namespace

TEST_CASE(
    "an output follows at once only what is declared to feed through, and some of that it does follow") {
  for (const BlockType* type : library().types()) {
    const Pairs declared = pairs_of(*type);
    bool any = declared.empty();
    for (const auto& [pair, follows] : declared) {
      any = any || follows;
      if (!follows) UNSCOPED_INFO(pair << " is declared to feed through and was not seen to");
    }
    INFO(type->name);
    CHECK(any);
  }
}
