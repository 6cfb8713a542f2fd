#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/allocations.hpp"

using namespace stepwire;

namespace {

constexpr std::int64_t min_steps = 10'000;

/// Requests for memory by the steps of one run; adds its steps to `steps`.
long requests_of_run(run::Executor& simulation, std::int64_t& steps) {
  simulation.reset();
  const long before = allocations();
  while (!simulation.finished() && simulation.healthy() && steps < min_steps) {
    simulation.evaluate();
    simulation.advance();
    ++steps;
  }
  return allocations() - before;
}

}  // namespace

TEST_CASE("requests for memory are counted, those of matrices too") {
  const long before = allocations();
  const auto number = std::make_unique<double>(1.0);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(100, *number);
  const long after = allocations();
  CHECK(vector.sum() == 100.0);
  CHECK(after - before == 2);
}

TEST_CASE("no diagram asks for memory in ten thousand steps") {
  for_every_diagram([](const plan::Plan& plan) {
    run::Executor simulation(plan);
    std::int64_t steps = 0;
    long requests = 0;
    while (steps < min_steps) requests += requests_of_run(simulation, steps);
    CHECK(steps == min_steps);
    CHECK(requests == 0);
  });
}
