// The points of a sweep before the first of them runs.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

Job job_of(const std::string& yaml, unsigned threads) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", "stepwire: 1\nstep: 1 ms\nstop: 1 s\n" + yaml);
  diagram::Loader loader(library());
  return make_job(loader, folder.path("sweep.yaml"), {}, {}, {}, threads);
}

std::string refusal_of(const std::string& yaml, unsigned threads) {
  try {
    job_of(yaml, threads);
  } catch (const yaml::Error& error) {
    return error.faults().front().text();
  }
  return {};
}

/// Two structures by turns, with 400 values each.
const std::string two_structures = R"(
solver: rk4
parameters: {k: 1}
blocks:
  wave: {block: Sine, frequency: 1 Hz, amplitude: $k}
  lag:  {block: Lag, u: wave, tau: 50 ms}
record: lag
sweep: {k: {from: 1, to: 400, count: 400}, solver: [rk4, euler]}
)";

/// The mass of point 701 is 0 kg.
const std::string refused_late = R"(
parameters: {m: {value: 1 kg, above: 0 kg}}
blocks:
  push: {block: Constant, value: 1 N}
  cart: {block: Mass, force: push, mass: $m}
record: cart.position
solver: rk4
sweep: {m: {from: 700 kg, to: -299 kg, count: 1000}}
)";

}  // namespace

TEST_CASE("each structure of a sweep has one plan, at any number of threads") {
  for (const unsigned threads : {1u, 2u, 5u}) {
    const Job job = job_of(two_structures, threads);
    REQUIRE(job.points.size() == 800);
    CHECK(job.family->size() == 2);
    for (std::size_t point = 0; point < job.points.size(); ++point)
      REQUIRE(job.points[point].member == point % 2);
  }
}

TEST_CASE("what differs between the points of a sweep is the same at any number of threads") {
  const auto differs = [](unsigned threads) { return job_of(two_structures, threads).family->variable(0); };
  const std::vector<plan::VariableBlock> one = differs(1);
  REQUIRE(one.size() == 1);
  for (const unsigned threads : {2u, 5u}) {
    const auto other = differs(threads);
    REQUIRE(other.size() == 1);
    CHECK(other[0].block == one[0].block);
    CHECK(other[0].items == one[0].items);
  }
}

TEST_CASE("of the points of a sweep the first that is refused is named, at any number of threads") {
  for (const unsigned threads : {1u, 2u, 5u})
    CHECK_THAT(refusal_of(refused_late, threads), Catch::Contains("(in the run with m=0 kg)"));
}

}  // namespace stepwire::run
