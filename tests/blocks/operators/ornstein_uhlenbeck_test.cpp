#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::vector<double> drift(const std::string& along, const std::string& keys, const std::string& what = "d") {
  return column(run_text("step: 10 ms\nstop: 1999.99 s\nblocks:\n  s: " + along +
                         "\n  d: {block: OrnsteinUhlenbeck, along: s, " + keys + "}\nrecord: [d]\n"),
                what);
}

double covariance(const std::vector<double>& x, std::size_t apart) {
  double sum = 0.0;
  for (std::size_t i = apart; i < x.size(); ++i) sum += x[i] * x[i - apart];
  return sum / static_cast<double>(x.size() - apart);
}

const std::string clock_line = "{block: Clock}";

}  // namespace

TEST_CASE("A drift keeps its variance and is correlated as an exponential of the way between") {
  const auto x = drift(clock_line, "seed: 3, deviation: 2, correlation: 0.5 s");
  // 2000 s of 0.5 s correlation: 2000 independent pieces, so that a variance of 4 errs by 0.13
  CHECK(covariance(x, 0) == Approx(4.0).margin(0.5));
  for (std::size_t ticks : {25, 50, 100})
    CHECK(covariance(x, ticks) ==
          Approx(4.0 * std::exp(-0.01 * static_cast<double>(ticks) / 0.5)).margin(0.5));
  CHECK(std::abs(covariance(x, 500)) < 0.5);
}

TEST_CASE("A drift goes over any coordinate, forward and back, and rests with it") {
  const auto twice = drift("{block: Ramp, slope: 2}", "seed: 3, correlation: 1");
  const auto back = drift("{block: Ramp, slope: -2}", "seed: 3, correlation: 1");
  CHECK(twice == back);
  CHECK(twice == drift("{block: Ramp, slope: 1}", "seed: 3, correlation: 0.5"));
  const auto rest = drift("{block: Constant, value: 7}", "seed: 3, deviation: 45 deg, correlation: 1");
  CHECK(rest.front() != 0.0);
  for (double v : rest) REQUIRE(v == rest.front());
}

TEST_CASE("The first value is as far from 0 as any other") {
  double square = 0.0;
  const int persons = 2000;
  for (int seed = 1; seed <= persons; ++seed) {
    const Table run = run_text(
        "step: 1 s\nstop: 1 s\nblocks:\n  d: {block: OrnsteinUhlenbeck, along: 0, deviation: 3, seed: " +
        std::to_string(seed) + "}\nrecord: [d]\n");
    square += std::pow(column(run, "d").front(), 2) / persons;
  }
  CHECK(square == Approx(9.0).margin(5.0 * 9.0 * std::sqrt(2.0 / persons)));
}

TEST_CASE("Its elements are independent, and a seed tells all of them") {
  const std::string keys = "deviation: [1, 1], correlation: 0.1 s, seed: ";
  const auto x = drift(clock_line, keys + "5", "d.1"), y = drift(clock_line, keys + "5", "d.2");
  double product = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) product += x[i] * y[i] / static_cast<double>(x.size());
  CHECK(std::abs(product) < 0.05);
  CHECK(x == drift(clock_line, keys + "5", "d.1"));
  CHECK(x != drift(clock_line, keys + "6", "d.1"));
}
