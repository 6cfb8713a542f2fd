#include <catch2/catch.hpp>

#include "tests/support/allocations.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

TEST_CASE("a step allocates nothing, with any solver") {
  for (const solve::SolverKind& kind : solve::solver_kinds()) {
    const plan::Plan plan = plan_text(R"(step: 1 ms
stop: 20 s
blocks:
  noise: {block: Noise, seed: 1, every: 10 ms}
  wave: {block: Sine, frequency: 3 Hz, amplitude: [1, 2, 3]}
  drive: {block: Sum, u: [noise, wave]}
  pair: {block: Mux, u: [drive, noise]}
  turned: {block: MatrixGain, gain: [[1, 0, 0, 1], [0, 1, 1, 0]], u: pair}
  x: {block: Integrator, u: turned}
  formula: {block: Expression, expression: "u1 > 0 ? sin(u1) : u2", u: [x, noise]}
  damper: {block: MRDamper, preset: rd-1097-01, velocity: 0.01, current: 0.2 A}
  late: {block: Delay, delay: 50 ms, u: x}
solver: )" + kind.name);
    Executor simulation(plan);
    const long before = allocations();
    for (int tick = 0; tick < 10'000; ++tick) {
      simulation.evaluate();
      simulation.advance();
    }
    const long after = allocations();
    INFO(kind.name);
    CHECK(after == before);
    CHECK(simulation.healthy());
  }
}

}  // namespace stepwire::run
