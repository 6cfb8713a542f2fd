#include "engine/analyse/statistics/return_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The region is x <= 0; the way back is along -x.
Eigen::Vector2d to_half_plane(const Eigen::Vector2d& point) {
  return point.x() > 0.0 ? Eigen::Vector2d(-7.0, 0.0) : Eigen::Vector2d::Zero();
}

/// A straight line of `length` that is `angle` off the way back and ends on the boundary.
PlanePoints straight(double length, double angle, Eigen::Index points) {
  PlanePoints path(2, points);
  for (Eigen::Index i = 0; i < points; ++i) {
    const double to_go = length * (1.0 - static_cast<double>(i) / static_cast<double>(points - 1));
    path.col(i) = to_go * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  path.rightCols(1).setZero();
  return path;
}

PlanePoints quantised(PlanePoints path, double step) {
  return step * (path.array() / step).round();
}

}  // namespace

TEST_CASE("a straight path scores its length times its angle, however it is sampled") {
  for (const double angle : {0.0, 10 * degree, 90 * degree - 1e-9}) {
    const PlanePoints path = straight(20.0, angle, 173);
    for (const double spacing : {0.1, 0.7, 3.0, 100.0})
      for (const auto rule : {Resampling::Rule::arc_length, Resampling::Rule::chord}) {
        const ReturnError found = return_error(path, to_half_plane, {rule, spacing});
        CHECK(found.error == Approx(20.0 * angle).margin(1e-9));
        CHECK(found.raw == Approx(20.0 * angle).margin(1e-9));
        CHECK(found.length == Approx(20.0));
        CHECK(found.raw_points == 173);
      }
  }
}

TEST_CASE("an encoder's steps swell the raw error, and resampling takes them out") {
  // 20 mm at 10 degrees: 3.49 mm rad; in steps of 0.47 mm every step is along an axis.
  const PlanePoints path = quantised(straight(20.0, 10 * degree, 2000), 0.47);
  const double right = 20.0 * 10 * degree;
  for (const auto rule : {Resampling::Rule::arc_length, Resampling::Rule::chord}) {
    const ReturnError found = return_error(path, to_half_plane, {rule, 5.0});
    CHECK(found.raw > 1.4 * right);
    CHECK(found.error == Approx(right).epsilon(0.1));
  }
}

TEST_CASE("a half circle around the region scores the right angle on all its length") {
  // On a circle about the origin every step is at right angles to the way to the origin.
  const auto to_disc = [](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p.norm() > 1.0 ? Eigen::Vector2d(-p) : Eigen::Vector2d::Zero();
  };
  constexpr Eigen::Index count = 4001;
  PlanePoints path(2, count + 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / (count - 1);
    path.col(i) << 5.0 * std::cos(angle), 5.0 * std::sin(angle);
  }
  path.col(count) << -1.0, 0.0;  // straight back: nothing is added
  const ReturnError found = return_error(path, to_disc, {Resampling::Rule::arc_length, 0.01});
  CHECK(found.error == Approx(5.0 * std::numbers::pi * 0.5 * std::numbers::pi).epsilon(2e-3));
  CHECK(found.raw == Approx(5.0 * std::numbers::pi * 0.5 * std::numbers::pi).epsilon(1e-3));
}

TEST_CASE("what comes behind the first point inside is left out") {
  PlanePoints path(2, 5);
  path << 3, 2, 0, -1, 4, 0, 0, 0, 5, 9;
  const ReturnError found = return_error(path, to_half_plane, {Resampling::Rule::arc_length, 0.5});
  CHECK(found.raw_points == 3);
  CHECK(found.length == 3.0);
  CHECK(found.points == 7);
  CHECK(found.error == Approx(0.0).margin(1e-12));
}

TEST_CASE("a step straight away from the region scores pi on its length") {
  PlanePoints path(2, 3);
  path << 1, 3, 0, 0, 0, 0;
  CHECK(return_error(path, to_half_plane, {Resampling::Rule::arc_length, 0.5}).error ==
        Approx(2.0 * std::numbers::pi));
}

TEST_CASE("resampled points have equal distances and lie on the path") {
  const PlanePoints path = straight(10.0, 0.3, 7);
  const PlanePoints points = resampled(path, {Resampling::Rule::arc_length, 3.0});
  REQUIRE(points.cols() == 5);  // four steps of 2.5
  for (Eigen::Index i = 0; i < 4; ++i) CHECK((points.col(i + 1) - points.col(i)).norm() == Approx(2.5));
  CHECK(points.col(0) == path.col(0));
  CHECK(points.col(4) == path.col(6));
}

TEST_CASE("dividers walk past noise that arc length counts") {
  // A hand rests for a thousand samples beside a sensor with noise, then goes straight back.
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  PlanePoints path(2, 1002);
  for (Eigen::Index i = 0; i < 1001; ++i) path.col(i) << 10.0 + noise(random), noise(random);
  path.col(1001) << 0.0, 0.0;
  const double by_arc = return_error(path, to_half_plane, {Resampling::Rule::arc_length, 1.0}).error;
  const double by_chord = return_error(path, to_half_plane, {Resampling::Rule::chord, 1.0}).error;
  CHECK(by_chord < 0.2);
  CHECK(by_arc > by_chord);
}

TEST_CASE("a chord's points lie one spacing apart, also after a turn") {
  PlanePoints corner(2, 3);
  corner << 0, 2.5, 2.5, 0, 0, 2.5;
  const PlanePoints points = resampled(corner, {Resampling::Rule::chord, 1.0});
  for (Eigen::Index i = 0; i + 2 < points.cols(); ++i)
    CHECK((points.col(i + 1) - points.col(i)).norm() == Approx(1.0));
  CHECK(points.col(points.cols() - 1) == corner.col(2));
  CHECK(points(1, 3) == Approx(std::sqrt(0.75)));  // from (2, 0) to x = 2.5
}

TEST_CASE("paths that cannot be scored are refused with the reason") {
  const PlanePoints path = straight(5.0, 0.0, 10);
  CHECK_THROWS_WITH(return_error(path.leftCols(9), to_half_plane), "the path never gets into the region");
  CHECK_THROWS_WITH(return_error(path.rowwise().reverse(), to_half_plane),
                    "the path starts inside the region");
  CHECK_THROWS_WITH(return_error(path.leftCols(1), to_half_plane),
                    "a path needs two points or more; there are 1");
  CHECK_THROWS_WITH(return_error(path, to_half_plane, {Resampling::Rule::chord, 0.0}),
                    "a spacing is above 0, not 0");
}

}  // namespace stepwire::statistics
