#include "engine/analyse/statistics/circle.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {

namespace {

constexpr CircleFit all_fits[] = {CircleFit::geometric, CircleFit::kasa, CircleFit::pratt, CircleFit::taubin};

PlanePoints arc(const Circle& circle, double from, double to, Eigen::Index count) {
  PlanePoints points(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
    points.col(i) = circle.centre + circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

/// The six points of Gander, Golub and Strebel (1994).
PlanePoints six_points() {
  PlanePoints points(2, 6);
  points << 1, 2, 5, 7, 9, 3, 7, 6, 8, 7, 5, 7;
  return points;
}

void check(const Circle& circle, double x, double y, double radius, double margin) {
  CHECK(circle.centre.x() == Approx(x).epsilon(0).margin(margin));
  CHECK(circle.centre.y() == Approx(y).epsilon(0).margin(margin));
  CHECK(circle.radius == Approx(radius).epsilon(0).margin(margin));
}

}  // namespace

TEST_CASE("six published points are fitted as the literature prints it") {
  // Geometric and Kasa: Gander, Golub and Strebel 1994; Pratt and Taubin as Chernov's programs give them.
  const PlanePoints points = six_points();
  const Circle geometric = fit_circle(points);
  check(geometric, 4.739782, 2.983533, 4.714226, 6e-7);
  CHECK(squared_deviations(points, geometric) == Approx(1.227599).margin(6e-7));
  check(fit_circle(points, CircleFit::kasa), 4.742331, 3.835123, 4.108762, 6e-7);
  check(fit_circle(points, CircleFit::pratt), 4.615482, 2.807354, 4.911302, 6e-7);
  check(fit_circle(points, CircleFit::taubin), 4.613933, 2.795209, 4.879213, 6e-7);
}

TEST_CASE("every fit finds an exact circle, from a whole turn or a short arc") {
  const Circle circle{{0.31, -0.12}, 0.05};
  for (const CircleFit fit : all_fits)
    for (const double turn : {2.0, 1.0, 0.2}) {
      INFO(static_cast<int>(fit) << ", " << turn << " pi");
      const Circle found = fit_circle(arc(circle, 0.4, 0.4 + turn * std::numbers::pi, 50), fit);
      check(found, 0.31, -0.12, 0.05, 1e-11);
      CHECK(squared_deviations(arc(circle, 0.0, 6.0, 50), found) < 1e-20);
    }
}

TEST_CASE("three points lie on their circumscribed circle") {
  PlanePoints points(2, 3);
  points << 0, 4, 0, 0, 0, 3;
  for (const CircleFit fit : all_fits) check(fit_circle(points, fit), 2.0, 1.5, 2.5, 1e-11);
}

TEST_CASE("a fit moves and scales with its points") {
  const Circle here = fit_circle(six_points());
  for (const CircleFit fit : all_fits) {
    const Circle plain = fit_circle(six_points(), fit);
    const PlanePoints far = (1e-3 * six_points()).colwise() + Eigen::Vector2d(1000.0, -500.0);
    const Circle moved = fit_circle(far, fit);
    CHECK(moved.radius == Approx(1e-3 * plain.radius).epsilon(1e-8));
    CHECK(moved.centre.x() == Approx(1000.0 + 1e-3 * plain.centre.x()).epsilon(1e-12));
  }
  CHECK(here.radius > 0.0);
}

TEST_CASE("the geometric fit has the smallest sum of squared deviations") {
  const double least = squared_deviations(six_points(), fit_circle(six_points()));
  for (const CircleFit fit : {CircleFit::kasa, CircleFit::pratt, CircleFit::taubin})
    CHECK(squared_deviations(six_points(), fit_circle(six_points(), fit)) > least);
  for (const double dx : {-1e-3, 1e-3}) {
    Circle near = fit_circle(six_points());
    near.centre.x() += dx;
    CHECK(squared_deviations(six_points(), near) > least);
  }
}

TEST_CASE("alternating deviations of one size leave centre and radius, and are summed") {
  const Circle circle{{2.0, 3.0}, 10.0};
  PlanePoints points = arc(circle, 0.0, 2.0 * std::numbers::pi, 40);
  for (Eigen::Index i = 0; i < 40; ++i)
    points.col(i) += (i % 2 == 0 ? 0.1 : -0.1) * (points.col(i) - circle.centre) / circle.radius;
  const Circle found = fit_circle(points);
  check(found, 2.0, 3.0, 10.0, 1e-10);
  CHECK(squared_deviations(points, found) == Approx(40 * 0.01).epsilon(1e-10));
}

TEST_CASE("on a noisy quarter Kasa's radius is too small and the geometric one is not") {
  // The leading bias of Kasa's radius (Al-Sharadqah and Chernov 2009) is many times that of the others.
  const Circle circle{{0.0, 0.0}, 1.0};
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.05);
  double geometric = 0.0, kasa = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    PlanePoints points = arc(circle, 0.0, 0.5 * std::numbers::pi, 60);
    for (double& value : points.reshaped()) value += noise(random);
    geometric += fit_circle(points).radius / 200.0;
    kasa += fit_circle(points, CircleFit::kasa).radius / 200.0;
  }
  CHECK(geometric == Approx(1.0).margin(0.02));
  CHECK(kasa < 0.97);
}

TEST_CASE("points without a circle are refused with the reason") {
  PlanePoints line(2, 5);
  line << 0, 1, 2, 3, 4, 1, 3, 5, 7, 9;
  for (const CircleFit fit : all_fits)
    CHECK_THROWS_WITH(fit_circle(line, fit),
                      Catch::StartsWith("the points lie on a line, or so near to one"));
  CHECK_THROWS_AS(fit_circle(PlanePoints::Constant(2, 9, 3.0)), StatisticsError);
  CHECK_THROWS_WITH(fit_circle(line.leftCols(2)), "a circle needs three points or more; there are 2");
  line(0, 2) = NAN;
  CHECK_THROWS_WITH(fit_circle(line), "a coordinate is no finite number");
}

}  // namespace stepwire::statistics
