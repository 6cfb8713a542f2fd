// Rule for steps that are examined for crossings. The right answers are those of sines with known turns.
#include "engine/simulate/solve/crossing_signs.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace stepwire::solve {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Crossing functions that are followed from step to step.
class Followed {
 public:
  explicit Followed(std::vector<double> first)
      : before_(std::move(first)), past_(CrossingPast::size(before_.size())) {}

  /// Takes a step to these numbers. Returns true if it is eventful.
  bool step(const std::vector<double>& after, double length = 1.0) {
    const bool found = is_eventful(before_.data(), after.data(), {past_.data(), after.size()},
                                   {length, false, true, true, false});
    before_ = after;
    return found;
  }

 private:
  std::vector<double> before_, past_;
};

/// A sine above or below an offset, by the number of a step.
struct Wave {
  double offset, amplitude, steps, phase;

  double angle(double step) const { return 2.0 * std::numbers::pi * step / steps + phase; }
  double operator()(double step) const { return offset + amplitude * std::sin(angle(step)); }
  /// True if the sine has its least value, at an angle of 3/2 pi, within the step.
  bool turns_after(double step) const {
    const double turn = 1.5 * std::numbers::pi, round = 2.0 * std::numbers::pi;
    return std::floor((angle(step) - turn) / round) != std::floor((angle(step + 1.0) - turn) / round);
  }
};

}  // namespace

TEST_CASE("every turn of a sine beyond 0 is examined, from 2.5 steps a period on") {
  int turns = 0;
  for (const double steps : {2.5, 2.9, 3.3, 4.0, 5.7, 8.0, 13.1, 29.0, 101.3})
    for (int part = 0; part < 200; ++part) {
      const double depth = 0.9 * part / 200.0, phase = 0.37 * part;
      const Wave wave{1.0 - depth, 1.0, steps, phase};
      Followed number({wave(0.0)});
      for (int step = 0; step < 120; ++step) {
        const double now = wave(step), next = wave(step + 1);
        const bool found = number.step({next});
        if (now <= 0.0 || next <= 0.0 || !wave.turns_after(step) || depth == 0.0) continue;
        INFO(steps << " steps a period, " << depth << " beyond 0, step " << step);
        CHECK(found);
        ++turns;
      }
    }
  CHECK(turns > 1000);
}

TEST_CASE("steps of other lengths do not hide a turn") {
  int turns = 0;
  const Wave wave{0.995, 1.0, 16.0, 0.4};  // its turns last two steps of the longest kind
  Followed number({wave(0.0)});
  double at = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const double length = 0.4 + 0.35 * std::sin(0.71 * step), now = wave(at), next = wave(at + length);
    const bool found = number.step({next}, length);
    const double dip = 1.5 * std::numbers::pi;
    const bool turned = std::floor((wave.angle(at) - dip) / (2.0 * std::numbers::pi)) !=
                        std::floor((wave.angle(at + length) - dip) / (2.0 * std::numbers::pi));
    at += length;
    if (now <= 0.0 || next <= 0.0 || !turned) continue;
    CHECK(found);
    ++turns;
  }
  CHECK(turns > 10);
}

TEST_CASE("numbers far from 0, at rest, or infinite are not examined after the first step") {
  Followed numbers({1000.0, -3.0, 0.0, infinity, -infinity});
  CHECK(numbers.step({1000.0, -3.0, 0.0, infinity, -infinity}));
  int found = 0;
  for (int step = 1; step < 1000; ++step)
    found += numbers.step({1000.0 + std::sin(0.1 * step), -3.0, 0.0, infinity, -infinity});
  CHECK(found == 0);
}

TEST_CASE("a number that falls evenly to its crossing is examined only where it crosses") {
  Followed number({10.05});
  int found = 0;
  for (int step = 1; step < 20; ++step) found += number.step({10.05 - step});
  CHECK(found == 2);  // the first step, and the one with the crossing
}

TEST_CASE("a crossing is seen, whatever was known of its number") {
  for (const double start : {1.0, 1e-300, 1e300, infinity})
    for (const double end : {-1.0, -1e-300, 0.0, -infinity}) {
      Followed number({start});
      for (int step = 0; step < 5; ++step) number.step({start});
      CHECK_FALSE(number.step({start}));
      CHECK(number.step({end}));
    }
}

TEST_CASE("a crossing that rounding has put behind a tick is one at the tick") {
  Followed number({2.0});
  number.step({1.0});
  number.step({0.5});
  CHECK(number.step({1e-12}));
}

}  // namespace stepwire::solve
