#include "engine/analyse/study/signal_map.hpp"

#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::study {
using Catch::Contains;

namespace {

/// A place that moves, a region of 10 mm about the origin, and the way back to it, which a slower block
/// computes.
const std::string field = R"(
blocks:
  place:   {block: Ramp, slope: 1 mm/s}
  up:      {block: Constant, value: 0 mm}
  at:      {block: Mux, u: [place, up]}
  late:    {block: UnitDelay, u: at}
  map:     {block: Region, position: at, shape: {center: [0 mm, 0 mm], radius: 10 mm}, every: 2 s}
  outside: {block: Compare, u: map.distance, operator: ">", to: 0 mm}
  back:    {block: Gain, u: map.direction, gain: -1}
  way:     {block: Product, u: [back, outside]}
  behind:  {block: Sum, u: [late, way]}
units: {at: m, back: m, behind: m, way: m}
record: [at, way, behind]
)";

diagram::SignalRef recorded(const plan::Plan& plan, const std::string& name) {
  for (const diagram::RecordedSignal& signal : plan.diagram.records.front().signals)
    if (signal.name == name) return signal.signal;
  FAIL(name << " is not recorded");
  return {};
}

}  // namespace

TEST_CASE("a signal is evaluated as a function of another one, wherever that is, in any order") {
  const plan::Plan plan = plan_text(field);
  const SignalMap way(plan.diagram, recorded(plan, "at"), recorded(plan, "way"), {});
  for (int round = 0; round < 2; ++round)
    for (const double angle : {0.3, 2.0, -1.2}) {
      const Eigen::Vector2d outward(std::cos(angle), std::sin(angle));
      CHECK((way(0.025 * outward) + outward).norm() == Approx(0.0).margin(1e-12));
      CHECK(way(0.004 * outward).norm() == 0.0);
    }
}

TEST_CASE("a switch is a function of its inputs, at ticks and with located events") {
  const std::string switched = field;
  const std::string yaml = switched.substr(0, switched.find("units:")) +
                           "  chosen:  {block: Switch, control: outside, then: back, else: at}\n"
                           "units: {at: m, back: m, behind: m, way: m}\nrecord: [at, chosen]\n";
  for (const char* events : {"", "events: locate\n"}) {
    const plan::Plan plan = plan_text(yaml + events);
    const SignalMap chosen(plan.diagram, recorded(plan, "at"), recorded(plan, "chosen"), {});
    const Eigen::Vector2d outward(0.6, 0.8);
    CHECK((chosen(0.025 * outward) + outward).norm() == Approx(0.0).margin(1e-12));
    CHECK((chosen(0.004 * outward) - 0.004 * outward).norm() == Approx(0.0).margin(1e-15));
    CHECK((chosen(0.025 * outward) + outward).norm() == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("a signal that remembers is no function of another one, and the block that does is named") {
  const plan::Plan plan = plan_text(field);
  try {
    const SignalMap behind(plan.diagram, recorded(plan, "at"), recorded(plan, "behind"), {"a.yaml", {3, 4}});
    FAIL("a delay was taken");
  } catch (const yaml::Error& error) {
    CHECK_THAT(error.what(),
               Catch::StartsWith("a.yaml:3:4: study.way_back: is no function of the place alone") &&
                   Contains("'late' (UnitDelay)"));
  }
}

}  // namespace stepwire::study
