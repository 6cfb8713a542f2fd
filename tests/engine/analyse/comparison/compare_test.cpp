#include "engine/analyse/comparison/compare.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace stepwire::comparison {

using Catch::Contains;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

table::Table table_of(std::vector<double> time, std::vector<double> values, const std::string& unit = "N",
                      const std::string& time_unit = "s") {
  return {{{"time", time_unit, std::move(time)}, {"f", unit, std::move(values)}}};
}

/// A function at 0, step, 2 step, ..., end.
table::Table sampled(double step, double end, const std::function<double(double)>& function,
                     const std::string& unit = "N") {
  std::vector<double> time, values;
  for (int i = 0; i <= std::lround(end / step); ++i) {
    time.push_back(i * step);
    values.push_back(function(time.back()));
  }
  return table_of(time, values, unit);
}

RecordingDifference difference_of(const table::Table& a, const table::Table& b,
                                  const Tolerance& tolerance = {}) {
  const table::Table *of_a = &a, *of_b = &b;
  return compare({&of_a, 1}, {&of_b, 1}, {{{"*", tolerance}}, {}});
}

/// The difference of the one signal; the comparison must be possible.
SignalDifference of_signal(const table::Table& a, const table::Table& b, const Tolerance& tolerance = {}) {
  const RecordingDifference found = difference_of(a, b, tolerance);
  INFO((found.faults.empty() ? "" : found.faults.front()));
  REQUIRE(found.faults.empty());
  REQUIRE(found.signals.size() == 1);
  CHECK(found.agrees == found.signals.front().agrees);
  return found.signals.front();
}

std::string fault_of(const table::Table& a, const table::Table& b, const Tolerance& tolerance = {}) {
  const RecordingDifference found = difference_of(a, b, tolerance);
  CHECK_FALSE(found.agrees);
  return found.faults.empty() ? "" : found.faults.front();
}

double step_at(double edge, double time) {
  return time >= edge - 1e-9 ? 1.0 : 0.0;
}

}  // namespace

TEST_CASE("two sines of 2 N and 2.02 N differ by 0.02 N, 1 %, at the quarter of their period") {
  const auto a = sampled(1e-3, 1.0, [](double t) { return 2.0 * std::sin(2.0 * M_PI * t); });
  const auto b = sampled(
      1e-3, 1.0, [](double t) { return 2020.0 * std::sin(2.0 * M_PI * t); }, "mN");
  const SignalDifference found = of_signal(a, b);
  CHECK(found.difference == Approx(0.02));
  CHECK(*found.share == Approx(0.01));
  CHECK(found.time == 0.25);
  CHECK(found.unit == "N");
  CHECK_FALSE(found.agrees);
  CHECK(of_signal(a, b, {.relative = 0.0101}).agrees);
  CHECK_FALSE(of_signal(a, b, {.relative = 0.0099}).agrees);
  CHECK(of_signal(a, b, {.absolute = 0.0201, .unit = unit::parse_unit("N")->dimension}).agrees);
  CHECK_FALSE(of_signal(a, b, {.absolute = 0.0199, .unit = unit::parse_unit("N")->dimension}).agrees);
}

TEST_CASE("an edge may be earlier or later by the jitter and no more, in either direction") {
  const auto a = sampled(1e-3, 1.0, [](double t) { return step_at(0.5, t); });
  for (const double shift : {-0.002, 0.002}) {
    const auto b = sampled(1e-3, 1.0, [&](double t) { return step_at(0.5 + shift, t); });
    CHECK(of_signal(a, b).differing == 2);
    CHECK(of_signal(a, b, {.jitter = 0.002}).agrees);
    CHECK_FALSE(of_signal(a, b, {.jitter = 0.0009}).agrees);
  }
}

TEST_CASE("a pulse shorter than the jitter that one side alone has is a difference") {
  const auto flat = sampled(1e-3, 1.0, [](double) { return 0.0; });
  auto pulse = flat;
  pulse.columns[1].values[200] = 1.0;
  CHECK_FALSE(of_signal(flat, pulse, {.jitter = 0.01}).agrees);
  CHECK_FALSE(of_signal(pulse, flat, {.jitter = 0.01}).agrees);
  CHECK(of_signal(flat, pulse, {.jitter = 0.01}).time == Approx(0.2));
}

TEST_CASE("a ramp shifted by the jitter agrees, one shifted by more differs by the rest of its slope") {
  const auto a = sampled(1e-3, 1.0, [](double t) { return 10.0 * t; });
  const auto b = sampled(1e-3, 1.0, [](double t) { return 10.0 * (t - 0.003); });
  CHECK(of_signal(a, b).difference == Approx(0.03));
  const SignalDifference rest =
      of_signal(a, b, {.absolute = 0.005, .unit = unit::parse_unit("N")->dimension, .jitter = 0.002});
  CHECK_FALSE(rest.agrees);
  CHECK(rest.difference == Approx(0.03).margin(1e-9));  // at the last row, behind which B has no value
  CHECK(of_signal(a, b, {.absolute = 0.0301, .unit = unit::parse_unit("N")->dimension, .jitter = 0.002})
            .agrees);
}

TEST_CASE("another rate is compared at the instants of A along straight lines") {
  // A chord of a parabola t^2 over a step of 10 ms is above it by 25e-6 in its middle.
  const auto a = sampled(1e-3, 1.0, [](double t) { return t * t; });
  const auto b = sampled(1e-2, 1.0, [](double t) { return t * t; });
  const SignalDifference found = of_signal(a, b);
  CHECK(found.method == Method::linear);
  CHECK(found.difference == Approx(25e-6).epsilon(1e-6));
  CHECK(found.rows == 1001);
  CHECK(of_signal(b, a).difference == Approx(0.0).margin(1e-12));  // rows of A are at every tenth of B
  CHECK(of_signal(b, a).method == Method::rows);
}

TEST_CASE("whole numbers without unit keep their value up to the next row") {
  const auto a = sampled(
      1e-3, 1.0, [](double t) { return std::floor(10.0 * t + 1e-9); }, "");
  const auto b = sampled(
      1e-1, 1.0, [](double t) { return std::floor(10.0 * t + 1e-9); }, "");
  CHECK(of_signal(a, b).agrees);
  CHECK(of_signal(a, b).method == Method::hold);
  CHECK_FALSE(of_signal(a, b, {.hold = false}).agrees);
}

TEST_CASE("nan on both sides is no difference, on one side it is one whatever the tolerance") {
  const auto a = table_of({0, 1, 2}, {1, nan, 3}), b = table_of({0, 1, 2}, {1, nan, 3}),
             c = table_of({0, 1, 2}, {1, 2, 3});
  CHECK(of_signal(a, b).agrees);
  for (const SignalDifference& one :
       {of_signal(a, c, {.relative = 10.0}), of_signal(c, a, {.relative = 10.0})}) {
    CHECK_FALSE(one.agrees);
    CHECK(one.missing == 1);
    CHECK(one.time == 1.0);
  }
}

TEST_CASE("both sides of an instant are compared, left with left and right with right") {
  const auto a = table_of({0, 1, 1, 2}, {0, 0, 5, 5});
  CHECK(of_signal(a, a).agrees);
  const SignalDifference left = of_signal(a, table_of({0, 1, 1, 2}, {0, 1, 5, 5}));
  CHECK(left.difference == 1.0);
  CHECK(left.a == 0.0);
  CHECK(of_signal(a, table_of({0, 1, 1, 2}, {0, 0, 7, 5})).difference == 2.0);
  // A run without instants has the value after it.
  const SignalDifference single = of_signal(a, table_of({0, 1, 2}, {0, 5, 5}));
  CHECK(single.agrees);
  CHECK(single.unpaired == 1);
}

TEST_CASE("a run that ends early or has other signals differs, and only the common part is compared") {
  const auto a = sampled(1e-2, 2.0, [](double t) { return t; });
  const auto b = sampled(1e-2, 1.0, [](double t) { return t; });
  const SignalDifference found = of_signal(a, b);
  CHECK_FALSE(found.agrees);
  CHECK(found.difference == 0.0);
  CHECK(found.rows == 101);
  REQUIRE(found.notes.size() == 1);
  CHECK(found.notes.front() == "ends at 2 s in A and at 1 s in B");
  auto more = a;
  more.columns.push_back({"g", "m", a.columns[1].values});
  const RecordingDifference one_more = difference_of(a, more);
  CHECK(one_more.only_in_b == std::vector<std::string>{"g"});
  CHECK_FALSE(one_more.agrees);
}

TEST_CASE("at another rate the shorter run may lack less than one of its steps, and no more") {
  const auto fine = sampled(1e-3, 1.0, [](double t) { return t; });
  const auto coarse = sampled(3e-3, 0.999, [](double t) { return t; });
  CHECK(of_signal(fine, coarse).agrees);
  CHECK(of_signal(coarse, fine).agrees);
  CHECK_FALSE(of_signal(fine, sampled(3e-3, 0.996, [](double t) { return t; })).agrees);
  CHECK_FALSE(of_signal(fine, sampled(1e-3, 0.999, [](double t) { return t; })).agrees);
}

TEST_CASE("runs of a sweep are compared one by one") {
  const auto a = table_of({0, 1, 0, 1}, {1, 2, 3, 4}), b = table_of({0, 1, 0, 1}, {1, 2, 3, 4.5});
  const SignalDifference found = of_signal(a, b);
  CHECK(found.run == 1);
  CHECK(found.difference == 0.5);
  CHECK_FALSE(of_signal(a, table_of({0, 1}, {1, 2})).agrees);
}

TEST_CASE("units of another dimension or meaning, and tolerances that do not fit, are refused") {
  const std::vector<double> time{0, 1}, values{1, 2};
  CHECK_THAT(fault_of(table_of(time, values, "N"), table_of(time, values, "m")),
             Contains("cannot be converted"));
  CHECK_THAT(fault_of(table_of(time, values, "N"), table_of(time, values, "")), Contains("f [N]"));
  CHECK_THAT(fault_of(table_of(time, values, "rad/s"), table_of(time, values, "Hz")), Contains("Hz"));
  CHECK_THAT(fault_of(table_of(time, values, "N"), table_of(time, values, "N"),
                      {.absolute = 0.1, .unit = unit::parse_unit("m")->dimension, .absolute_text = "0.1 m"}),
             Contains("0.1 m"));
  CHECK_THAT(fault_of(table_of(time, values, "mN"), table_of(time, values, "mN"),
                      {.absolute = 0.1, .absolute_text = "0.1"}),
             Contains("write 0.1 mN"));
  CHECK_THAT(fault_of(table_of(time, values, "degC"), table_of(time, values, "degC"), {.relative = 0.1}),
             Contains("tolerance in K"));
  CHECK_THAT(fault_of(table_of(time, {1, nan}), table_of({0, nan}, values)), Contains("no number in row 2"));
  const table::Table one = table_of(time, values), *tables = &one;
  CHECK_THAT(compare({&tables, 1}, {&tables, 1}, {{{"g*", {}}}, {}}).faults.at(0), Contains("'g*'"));
}

TEST_CASE("a difference of temperatures has no zero: 20 degC and 294.15 K differ by 1 degC") {
  const SignalDifference found =
      of_signal(table_of({0, 1}, {20, 20}, "degC"), table_of({0, 1}, {294.15, 294.15}, "K"));
  CHECK(found.difference == Approx(1.0));
  CHECK(found.b == Approx(21.0));
}

TEST_CASE("times may have another unit") {
  const SignalDifference found = of_signal(table_of({0, 1}, {1, 2}), table_of({0, 1000}, {1, 2}, "N", "ms"));
  CHECK(found.agrees);
  CHECK(found.method == Method::rows);
}

}  // namespace stepwire::comparison
