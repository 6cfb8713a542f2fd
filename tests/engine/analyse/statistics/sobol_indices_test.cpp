#include "engine/analyse/statistics/sensitivity_indices.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/sampling/design.hpp"

namespace stepwire::statistics {

namespace {

using Point = std::vector<double>;

/// The outcomes of a function at the points of a design, each number between 0 and 1.
std::vector<double> outcomes_of(const sampling::Points& points,
                                const std::function<double(const Point&)>& of) {
  std::vector<double> outcomes;
  for (std::size_t i = 0; i < points.front().size(); ++i) {
    Point point;
    for (const auto& numbers : points) point.push_back(numbers[i]);
    outcomes.push_back(of(point));
  }
  return outcomes;
}

double ishigami(const Point& share) {
  const auto x = [&](std::size_t i) { return std::numbers::pi * (2.0 * share[i] - 1.0); };
  return std::sin(x(0)) + 7.0 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

void check(const std::vector<Estimate>& found, const std::vector<double>& exact, double margin) {
  for (std::size_t i = 0; i < exact.size(); ++i) {
    CHECK(found[i].value == Approx(exact[i]).margin(margin));
    CHECK(found[i].interval.low <= found[i].value);
    CHECK(found[i].interval.high >= found[i].value);
    CHECK(found[i].interval.high - found[i].interval.low < 10.0 * margin);
  }
}

}  // namespace

TEST_CASE("indices of the function of Ishigami are those of its closed form") {
  constexpr double pi = std::numbers::pi;
  const double b = 0.1, p4 = std::pow(pi, 4), p8 = p4 * p4;
  const double alone = 0.5 * std::pow(1.0 + b * p4 / 5.0, 2), second = 49.0 / 8.0,
               both = 8.0 * b * b * p8 / 225.0;
  const double all = alone + second + both;
  const auto points = sampling::points_of({sampling::Layout::saltelli, 4096, 3}, 3);
  const SobolIndices indices = sobol_indices(outcomes_of(points, ishigami), 3, {});
  CHECK(indices.samples == 4096);
  check(indices.first, {alone / all, second / all, 0.0}, 0.015);
  check(indices.total, {(alone + both) / all, second / all, both / all}, 0.015);
}

TEST_CASE("of a sum each index is the share of its variance, alone and in total") {
  const auto sum = [](const Point& x) { return 4.0 * x[0] + 2.0 * x[1] + x[2]; };
  const auto points = sampling::points_of({sampling::Layout::saltelli, 2048, 1}, 3);
  const SobolIndices indices = sobol_indices(outcomes_of(points, sum), 3, {});
  check(indices.first, {16.0 / 21.0, 4.0 / 21.0, 1.0 / 21.0}, 0.01);
  check(indices.total, {16.0 / 21.0, 4.0 / 21.0, 1.0 / 21.0}, 0.01);
}

TEST_CASE("a sample with an outcome that is no number does not count, and equal outcomes have no indices") {
  auto outcomes = outcomes_of(sampling::points_of({sampling::Layout::saltelli, 64, 1}, 2),
                              [](const Point& x) { return x[0]; });
  outcomes[5] = std::nan("");
  CHECK(sobol_indices(outcomes, 2, {}).samples == 63);
  CHECK(std::isnan(sobol_indices(std::vector<double>(40, 1.0), 2, {}).first[0].value));
}

TEST_CASE("the same seed gives the same intervals, and more confidence wider ones") {
  const auto outcomes = outcomes_of(sampling::points_of({sampling::Layout::saltelli, 128, 1}, 3), ishigami);
  const auto width = [&](double confidence) {
    const Estimate one = sobol_indices(outcomes, 3, {confidence, 300, 1}).total[0];
    return one.interval.high - one.interval.low;
  };
  CHECK(width(0.9) == width(0.9));
  CHECK(width(0.99) > width(0.8));
}

TEST_CASE("effects of a sum are its slopes, the same everywhere") {
  const auto sum = [](const Point& x) { return 4.0 * x[0] - 2.0 * x[1] + 0.0 * x[2]; };
  const auto points = sampling::points_of({sampling::Layout::morris, 20, 1}, 3);
  std::vector<MorrisStep> steps;
  for (std::size_t i = 1; i < points[0].size(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      if (i % 4 != 0 && points[d][i] != points[d][i - 1])
        steps.push_back({d, points[d][i] - points[d][i - 1]});
  REQUIRE(steps.size() == 60);
  const MorrisEffects effects = morris_effects(outcomes_of(points, sum), steps, 3, {});
  const std::vector<double> slopes{4.0, -2.0, 0.0};
  for (std::size_t d = 0; d < 3; ++d) {
    CHECK(effects.mean[d].value == Approx(slopes[d]).margin(1e-12));
    CHECK(effects.size[d].value == Approx(std::abs(slopes[d])).margin(1e-12));
    CHECK(effects.deviation[d].value == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("fewer samples than four have no indices, and one trajectory has effects without a deviation") {
  for (const std::size_t samples : {1, 2, 3, 4}) {
    const auto outcomes =
        outcomes_of(sampling::points_of({sampling::Layout::saltelli, samples, 1}, 3), ishigami);
    const SobolIndices indices = sobol_indices(outcomes, 3, {});
    CHECK(indices.samples == samples);
    for (const std::vector<Estimate>* all : {&indices.first, &indices.total})
      for (const Estimate& one : *all) CHECK(std::isfinite(one.value) == (samples == 4));
  }
  const MorrisEffects effects =
      morris_effects(std::vector<double>{1.0, 3.0, 2.0}, {{0, 0.5}, {1, 0.5}}, 2, {});
  CHECK(effects.mean[0].value == 4.0);
  CHECK(effects.mean[1].value == -2.0);
  CHECK(std::isnan(effects.deviation[0].value));
  CHECK(std::isnan(effects.mean[0].interval.low));
}

}  // namespace stepwire::statistics
