#include "bench/agreement.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "bench/hand_written.hpp"
#include "bench/workload.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire {

namespace {

constexpr double tolerance = 1e-11;

/// State of W1 after a number of steps: x, v [mm, mm/s], z, i [A].
struct ReferenceW1 {
  int steps;
  std::array<double, 4> state;
};

constexpr ReferenceW1 references_w1[] = {
    {2000, {-22.0660615859992, 0.500905335020262, 1.10514893010915, 0.273227421053629}},
    {100000, {-23.1581554834532, 0.500891457269049, 1.10514961942006, 0.273227418748788}}};

/// Sum of all states of W2 after a number of steps.
struct ReferenceW2 {
  int blocks, steps;
  double sum;
};

constexpr ReferenceW2 references_w2[] = {{10, 1000, -0.0748070793824835},
                                         {100, 300, 1.62651668141925},
                                         {1000, 40, 0.395875330268821},
                                         {10000, 5, 0.0627443518970763}};

bool agrees(const std::string& what, double value, double reference) {
  const bool good = std::abs(value - reference) <= tolerance * std::abs(reference);
  if (!good) fmt::print("{}: {:.16g} where {:.16g} is right\n", what, value, reference);
  return good;
}

double state(const run::Executor& simulation, const std::string& name) {
  const auto& blocks = simulation.plan().diagram.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (blocks[b].name == name) return simulation.values()[simulation.plan().blocks[b].states[0].offset];
  return std::nan("");
}

void go(run::Executor& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    simulation.evaluate();
    simulation.advance();
  }
}

/// Steps with compiled code.
void go_compiled(run::Executor& simulation, int steps) {
  static codegen::GeneratedCode source{run::code_trial()};
  const std::optional<plan::CompiledPlan> code = source.compile(simulation.plan(), {}, {});
  if (code) simulation.use(*code);
  go(simulation, steps);
}

bool w1_agrees(const ReferenceW1& reference) {
  const plan::Plan plan = w1_plan();
  run::Executor simulation(plan);
  run::Executor generated(plan);
  go(simulation, reference.steps);
  go_compiled(generated, reference.steps);
  HandWrittenW1<> by_hand;
  for (int i = 0; i < reference.steps; ++i) by_hand.step();
  bool good = true;
  for (std::size_t i = 0; i < reference.state.size(); ++i) {
    const std::string name = std::array{"x", "v", "z", "amp"}[i];
    const std::string what = fmt::format("W1 {} after {} steps", name, reference.steps);
    good = agrees(what, state(simulation, name), reference.state[i]) && good;
    good = agrees(what + " generated", state(generated, name), reference.state[i]) && good;
    good = agrees(what + " by hand", by_hand.state()[i], reference.state[i]) && good;
  }
  return good;
}

double sum_of_states(const run::Executor& simulation, int blocks) {
  double sum = 0.0;
  for (int j = 0; j < blocks / 5; ++j) sum += state(simulation, fmt::format("x{}", j));
  return sum;
}

bool w2_agrees(const ReferenceW2& reference) {
  const plan::Plan plan = w2_plan(reference.blocks, reference.steps);
  run::Executor simulation(plan);
  run::Executor generated(plan);
  go(simulation, reference.steps);
  go_compiled(generated, reference.steps);
  HandWrittenW2<> by_hand(reference.blocks);
  for (int i = 0; i < reference.steps; ++i) by_hand.step();
  const std::string what = fmt::format("W2 {} after {} steps", reference.blocks, reference.steps);
  const bool good = agrees(what, sum_of_states(simulation, reference.blocks), reference.sum) &&
                    agrees(what + " generated", sum_of_states(generated, reference.blocks), reference.sum);
  return agrees(what + " by hand", by_hand.sum(), reference.sum) && good;
}

}  // namespace

bool results_agree() {
  bool good = true;
  for (const ReferenceW1& reference : references_w1) good = w1_agrees(reference) && good;
  for (const ReferenceW2& reference : references_w2) good = w2_agrees(reference) && good;
  return good;
}

}  // namespace stepwire
