#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/diagrams/diagram_files.hpp"

using namespace stepwire;

namespace {

/// Enough for every rate to have its turn.
std::int64_t end_of(const plan::Plan& plan) {
  return std::min<std::int64_t>(plan.steps, 2000);
}

}  // namespace

TEST_CASE("a diagram that is run twice gives the same bits") {
  for_every_diagram([](const plan::Plan& plan) {
    run::Executor one(plan), other(plan);
    const std::uint64_t first = fingerprint(one, end_of(plan));
    CHECK(fingerprint(other, end_of(plan)) == first);
    other.reset();
    CHECK(fingerprint(other, end_of(plan)) == first);
  });
}

TEST_CASE("a diagram that goes on from a kept moment gives the same bits") {
  for_every_diagram([](const plan::Plan& plan) {
    run::Executor simulation(plan), fresh(plan);
    fingerprint(simulation, end_of(plan) / 3);
    REQUIRE(simulation.healthy());
    const run::Workspace kept = simulation.workspace();
    const std::uint64_t rest = fingerprint(simulation, end_of(plan));
    simulation.restore(kept);
    CHECK(fingerprint(simulation, end_of(plan)) == rest);
    fresh.restore(kept);
    CHECK(fingerprint(fresh, end_of(plan)) == rest);
  });
}
