#include "blocks/haptics/directionality.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

using Plane = std::array<double, 2>;

/// The block at one instant, without a diagram around it.
struct Instant {
  Plane force, f_max, out{}, gain{};
  double angle;

  Instant(Directionality::Law law, Plane force, Plane f_max, double threshold = 0.0,
          std::optional<double> axes = {})
      : force(force), f_max(f_max), angle(axes.value_or(0.0)) {
    Directionality block;
    block.law = law;
    block.threshold = threshold;
    block.force.bind(this->force.data(), 2);
    block.f_max.bind(this->f_max.data(), 2);
    if (axes) block.angle.bind(&angle, 1);
    block.y.bind(out.data(), 2);
    block.gain.bind(gain.data(), 2);
    block.outputs();
  }
};

constexpr auto D1 = Directionality::Law::D1, D2 = Directionality::Law::D2;
constexpr int trials = 20'000;

double length(Plane v) {
  return std::hypot(v[0], v[1]);
}
Plane turned(Plane v, double angle) {
  return {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]};
}
Plane polar(double size, double angle) {
  return turned({size, 0.0}, angle);
}

/// Vectors of all directions and of very different lengths.
class Vectors {
 public:
  Plane next() { return polar(std::pow(10.0, size_(random_)), angle_(random_)); }
  double angle() { return angle_(random_); }

 private:
  std::mt19937 random_{20'240'501};
  std::uniform_real_distribution<> angle_{-std::numbers::pi, std::numbers::pi}, size_{-6.0, 3.0};
};

}  // namespace

TEST_CASE("No law of directionality asks for more than F_max, and every gain is from 0 to 1") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    for (const auto law : {D1, D2}) {
      const Instant is(law, force, f_max);
      REQUIRE(length(is.out) <= length(f_max) * (1.0 + 1e-15));
      for (const double gain : is.gain) REQUIRE((gain >= 0.0 && gain <= 1.0));
    }
  }
}

TEST_CASE("D1 is its law of each axis: F_max where the hand pushes against it, else nothing") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    const Instant is(D1, force, f_max);
    for (std::size_t k = 0; k < 2; ++k)
      REQUIRE(is.out[k] == (std::signbit(force[k]) != std::signbit(f_max[k]) ? f_max[k] : 0.0));
  }
}

TEST_CASE("D1 on axes that are turned is D1 of vectors that are turned back, and its answer turned along") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    const double angle = any.angle();
    const Instant straight(D1, turned(force, -angle), turned(f_max, -angle)),
        on_axes(D1, force, f_max, 0.0, angle);
    const Plane expected = turned(straight.out, angle);
    const double margin = 1e-12 * length(f_max);
    // Where the push is along an axis the sign of what is across it is that of the rounding.
    const double least = std::min(std::abs(turned(force, -angle)[0]), std::abs(turned(force, -angle)[1]));
    if (least < 1e-9 * length(force)) continue;
    CHECK(on_axes.out[0] == Approx(expected[0]).margin(margin));
    CHECK(on_axes.out[1] == Approx(expected[1]).margin(margin));
  }
}

TEST_CASE("On turned axes a component counts above the threshold, and D2 has no axes") {
  const double quarter = std::numbers::pi / 4.0;
  // Along the axis at 45 degrees the push is 1 N, across it 0.05 N; F_max is against both.
  const Plane force = turned({1.0, 0.05}, quarter), f_max = turned({-3.0, -4.0}, quarter);
  const Instant above(D1, force, f_max, 0.1, quarter);
  CHECK(turned(above.out, -quarter)[0] == Approx(-3.0));
  CHECK(turned(above.out, -quarter)[1] == Approx(0.0).margin(1e-12));
  const Instant with(D2, force, f_max, 0.1, quarter), without(D2, force, f_max, 0.1);
  CHECK(with.out == without.out);
}

TEST_CASE("D2 resists the push with |F_max| and the sine of its angle, beyond 90 degrees with all of it") {
  for (int degrees = 0; degrees <= 180; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Instant is(D2, polar(3.0, 0.4 + angle), polar(8.0, 0.4));
    const double gain = degrees < 90 ? std::sin(angle) : 1.0;
    CHECK(is.gain[0] == Approx(gain).margin(1e-15));
    CHECK(is.out[0] == Approx(-8.0 * gain * std::cos(0.4 + angle)).margin(1e-14));
    CHECK(is.out[1] == Approx(-8.0 * gain * std::sin(0.4 + angle)).margin(1e-14));
  }
}

TEST_CASE("D2 takes nothing but the angle between push and F_max: turned together, the answer turns along") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    const double angle = any.angle();
    const Plane straight = turned(Instant(D2, force, f_max).out, angle);
    const Plane aslant = Instant(D2, turned(force, angle), turned(f_max, angle)).out;
    for (std::size_t k = 0; k < 2; ++k) REQUIRE(std::abs(straight[k] - aslant[k]) <= 1e-13 * length(f_max));
  }
}

TEST_CASE("D2's gain changes by no more than the angle does, also across 0 and 90 degrees") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    const double step = 1e-4 * any.angle();
    const double here = Instant(D2, force, f_max).gain[0],
                 there = Instant(D2, turned(force, step), f_max).gain[0];
    REQUIRE(std::abs(here - there) <= std::abs(step) + 1e-14);
  }
}

TEST_CASE("The device only resists: its wanted force does no work on a hand that moves as it pushes") {
  Vectors any;
  for (int i = 0; i < trials; ++i) {
    const Plane force = any.next(), f_max = any.next();
    for (const auto law : {D1, D2}) {
      const Plane out = Instant(law, force, f_max).out;
      REQUIRE(out[0] * force[0] <= 0.0);
      REQUIRE(out[1] * force[1] <= 0.0);
    }
  }
}

TEST_CASE("Where the hand does not push, or F_max is 0, no force is wanted") {
  for (const auto law : {D1, D2}) {
    CHECK(length(Instant(law, {0.0, 0.0}, {8.0, -3.0}).out) == 0.0);
    CHECK(length(Instant(law, {2.0, 1.0}, {0.0, 0.0}).out) == 0.0);
    CHECK(length(Instant(law, {-0.05, 0.05}, {8.0, -3.0}, 0.1).out) == 0.0);
  }
  CHECK(Instant(D1, {-1.0, 0.0}, {8.0, -3.0}).out == Plane{8.0, 0.0});        // no push along y
  CHECK(Instant(D1, {-1.0, 0.05}, {8.0, -3.0}, 0.1).out == Plane{8.0, 0.0});  // as good as none
  CHECK(Instant(D2, {3.0, 8.0}, {8.0, -3.0}).gain[0] == 1.0);                 // at 90 degrees
  CHECK(Instant(D2, {2.0, 2.0}, {8.0, 8.0}).gain[0] == Approx(0.0).margin(1e-15));
}

TEST_CASE("With direction: motion it is the displacement over the last travel that counts, not the force") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 3 s
blocks:
  way:   {block: Pusher, points: [[0, 0], [10 mm, 10 mm], [20 mm, 10 mm]], speed: 10 mm/s}
  f_max: {block: Constant, value: [0 N, -8 N]}
  law:   {block: Directionality, law: D2, direction: motion, f_max: f_max, force: [0 N, 0 N], position: way.position, travel: 0.3 mm}
record: [law.y, law.gain, way.leg, way.distance]
)");
  const auto &x = column(table, "law.y.1"), &y = column(table, "law.y.2");
  CHECK((x[0] == 0.0 && y[0] == 0.0));  // nothing has moved yet
  CHECK(x[500] == Approx(-8.0 * std::sqrt(0.5)));
  CHECK(y[500] == Approx(-8.0 * std::sqrt(0.5)));
  CHECK(x.back() == Approx(-8.0));  // at 90 degrees, with all of it
  CHECK(y.back() == Approx(0.0).margin(1e-6));
}

TEST_CASE("A direction of the hand that nothing tells is refused") {
  const std::string head = "step: 1 ms\nstop: 1 s\nblocks:\n  d: {block: Directionality, f_max: [1 N, 0 N], ";
  CHECK_THAT(error_of(head + "force: [0, 0], direction: motion}\n"),
             Catch::Contains("d: the input 'position' is missing (direction is motion)"));
}
