#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <vector>

#include "engine/simulate/solve/solver.hpp"
#include "tests/support/allocations.hpp"

namespace stepwire::solve {

namespace {

/// A chain of lags, each fed by the one before it.
class Chain : public System {
 public:
  explicit Chain(std::size_t states) : states_(states, 0.0), slopes_(states, 0.0) {
    time = &time_;
    x = states_.data();
    dot = slopes_.data();
    count = states;
  }
  void evaluate() override {
    for (std::size_t i = 0; i < count; ++i) dot[i] = (i == 0 ? 1.0 : x[i - 1]) - x[i];
  }

 private:
  double time_ = 0.0;
  std::vector<double> states_, slopes_;
};

}  // namespace

TEST_CASE("counting sees what is allocated") {
  const long before = allocations();
  const std::vector<double> memory(100, 1.0);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(100, memory.back());
  const long after = allocations();
  CHECK(vector.sum() == 100.0);
  CHECK(after == before + 2);
}

TEST_CASE("no solver allocates in a step, whatever the number of states") {
  for (const SolverKind& kind : solver_kinds())
    for (std::size_t states = 1; states <= 20; ++states) {
      Chain chain(states);
      const auto solver =
          make_solver(kind.name, states, kind.fixed ? std::nullopt : std::optional(ErrorControl{}));
      const long before = allocations();
      for (int k = 0; k < 10; ++k) {
        chain.evaluate();
        solver->advance(chain, {0.1 * k, 0.1 * (k + 1), 0.1});
      }
      const long after = allocations();
      INFO(kind.name << " with " << states << " states");
      CHECK(after == before);
      CHECK(chain.x[0] > 0.5);
    }
}

}  // namespace stepwire::solve
