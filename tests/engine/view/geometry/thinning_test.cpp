#include "engine/view/geometry/thinning.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire::geometry {

namespace {

Curve sine(std::size_t rows) {
  Curve curve{{{}, {}}, 0};
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(rows - 1);
    curve.columns[0].push_back(t);
    curve.columns[1].push_back(std::sin(20.0 * t));
  }
  return curve;
}

/// A closed curve that turns in on itself: three loops a turn, each of them passed many times.
Curve loops(std::size_t rows) {
  Curve curve{{{}, {}}, 0};
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = 2.0 * 3.14159265358979 * 9.0 * static_cast<double>(i) / static_cast<double>(rows - 1);
    curve.columns[0].push_back(40.0 * (std::cos(t) + 0.6 * std::cos(4.01 * t)));
    curve.columns[1].push_back(3.0 * (std::sin(t) - 0.6 * std::sin(4.01 * t)));
  }
  return curve;
}

/// Largest distance of the rows of a curve from the line between those of it that are drawn, which come in
/// their order, in pixels of a picture that is 800 wide and high.
double pixels_off(const Curve& whole, const Curve& drawn, double width, double height) {
  const auto at = [&](const Curve& curve, std::size_t row) {
    return std::pair{800.0 * curve.columns[0][row] / width, 800.0 * curve.columns[1][row] / height};
  };
  double most = 0.0;
  std::size_t next = 1;
  for (std::size_t row = 0; row < whole.size(); ++row) {
    const auto [x, y] = at(whole, row);
    const auto [x0, y0] = at(drawn, next - 1);
    const auto [x1, y1] = at(drawn, next);
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    const double part = std::clamp(((x - x0) * dx + (y - y0) * dy) / square, 0.0, 1.0);
    most = std::max(most, std::hypot(x - x0 - part * dx, y - y0 - part * dy));
    if (x == x1 && y == y1 && next + 1 < drawn.size()) ++next;
  }
  return most;
}

/// Value of a curve between its rows.
double between(const Curve& curve, double x) {
  const auto& xs = curve.columns[0];
  const auto right = std::clamp<std::ptrdiff_t>(std::lower_bound(xs.begin(), xs.end(), x) - xs.begin(), 1,
                                                static_cast<std::ptrdiff_t>(xs.size()) - 1);
  const auto i = static_cast<std::size_t>(right);
  const double part = (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return curve.columns[1][i - 1] + part * (curve.columns[1][i] - curve.columns[1][i - 1]);
}

}  // namespace

TEST_CASE("a thinned curve keeps a peak of one row among a million") {
  Curve curve = sine(1'000'000);
  curve.columns[1][123'456] = 7.0;
  curve.columns[1][654'321] = -9.0;
  const Curve few = decimate(curve, 2000);
  CHECK(few.size() <= 2001);
  CHECK(*std::max_element(few.columns[1].begin(), few.columns[1].end()) == 7.0);
  CHECK(*std::min_element(few.columns[1].begin(), few.columns[1].end()) == -9.0);
  CHECK(few.columns[0].front() == 0.0);
  CHECK(few.columns[0].back() == 1.0);
  CHECK(std::is_sorted(few.columns[0].begin(), few.columns[0].end()));

  const Curves all{{curve}, {0.0}, false, {}, {}};
  const Curve thin = thinned(all, 0, 2000).at(0);
  CHECK(thin.size() <= 2000);
  CHECK(*std::max_element(thin.columns[1].begin(), thin.columns[1].end()) == 7.0);
  CHECK(*std::min_element(thin.columns[1].begin(), thin.columns[1].end()) == -9.0);
}

TEST_CASE("a simplified curve is nowhere farther from the whole one than its tolerance") {
  const Curve curve = sine(5000);
  const Curve simple = simplify(curve, {1.0, 2.0}, 1e-3, false);
  CHECK(simple.size() < 200);
  double most = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    most = std::max(most, std::abs(between(simple, curve.columns[0][i]) - curve.columns[1][i]) / 2.0);
  // The tolerance is across the curve, which is up to ten times as steep as wide.
  CHECK(most < 1e-2);
}

TEST_CASE("loops of many rows are drawn within half a pixel of each of their rows") {
  for (const std::size_t rows : {20'001u, 400'001u}) {
    const Curve curve = loops(rows);
    const Curves all{{curve}, {0.0}, false, {}, {}};
    const Curve thin = thinned(all, 0, 1750).at(0);
    INFO(rows << " rows, of which " << thin.size() << " are drawn");
    CHECK(thin.size() < 6000);
    const auto [left, right] = std::ranges::minmax(curve.columns[0]);
    const auto [low, high] = std::ranges::minmax(curve.columns[1]);
    CHECK(pixels_off(curve, thin, right - left, high - low) < 0.5);
  }
}

TEST_CASE("a straight path whose colour changes is cut where the colour does") {
  Curve ramp{{{}, {}, {}}, 0};
  for (int i = 0; i <= 1000; ++i) {
    ramp.columns[0].push_back(i);
    ramp.columns[1].push_back(0.0);
    ramp.columns[2].push_back(i < 500 ? 0.0 : (i - 500) / 500.0);
  }
  const Curve simple = simplify(ramp, {1000.0, 1.0, 1.0}, 2.5e-4, true);
  CHECK(simple.size() > 80);
  CHECK(simple.size() < 130);
  CHECK(simple.columns[0][1] > 500.0);
}

TEST_CASE("a straight path whose colour jumps has its old colour up to the jump") {
  Curve jump{{{}, {}, {}}, 0};
  for (int i = 0; i <= 1000; ++i) {
    jump.columns[0].push_back(i);
    jump.columns[1].push_back(0.0);
    jump.columns[2].push_back(i < 500 ? 3.4 : 5.2);
  }
  const Curve simple = simplify(jump, {1000.0, 1.0, 1.8}, 2.5e-4, true);
  CHECK(simple.columns[0] == std::vector<double>{0.0, 499.0, 500.0, 1000.0});
  CHECK(simple.columns[2] == std::vector<double>{3.4, 3.4, 5.2, 5.2});
}

TEST_CASE("a curve is as fine as the part of its axis that is shown needs") {
  Curve curve = sine(5000);
  curve.columns[1].back() = 1000.0;
  const Curves whole{{curve}, {0.0}, false, {}, {}};
  const Curves part{{curve}, {0.0}, false, {1.0, 2.0}, {}};
  CHECK(thinned(whole, 0, 5000).at(0).size() < 30);
  CHECK(thinned(part, 0, 5000).at(0).size() > 100);
}

TEST_CASE("points are cut to their share without regard to shape") {
  Curve line{{{}, {}}, 0};
  for (int i = 0; i < 100; ++i)
    for (auto& column : line.columns) column.push_back(i);
  const Curves all{{line, line}, {0.0}, false, {}, {}};
  CHECK(cut(all, 0, 1000).at(0).size() == 100);
  CHECK(cut(all, 0, 100).at(0).size() >= 20);
  CHECK(thinned(all, 0, 1000).at(0).size() == 2);
}

}  // namespace stepwire::geometry
