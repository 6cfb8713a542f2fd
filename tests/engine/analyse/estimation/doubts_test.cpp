#include "engine/analyse/estimation/fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/estimation/least_squares.hpp"
#include "tests/engine/analyse/estimation/fit_text.hpp"
#include "tests/engine/analyse/estimation/nist.hpp"

namespace stepwire::estimation {
using Catch::Contains;

namespace {

const std::string line =
    "  parameters: {slope: {start: 0.5}, bias: {start: 1}}\n"
    "  compare: [{model: model, measured: y}]\n";

NistSet small_set(const std::string& name) {
  for (NistSet& set : small_nist_sets())
    if (set.name == name) return set;
  FAIL("there is no set " << name);
  return {};
}

}  // namespace

TEST_CASE("a standard error of more than a hundred values and a record below its mean send to other starts") {
  FitResult result;
  result.numbers = {FittedNumber{.name = "b1", .value = 2.0, .standard_error = 150.0},
                    FittedNumber{.name = "b2", .value = 2.0, .standard_error = 250.0}};
  result.records = {FittedRecord{.label = "10 mm", .comparisons = {ComparedRows{.agreement = -65.0}}},
                    FittedRecord{.label = "20 mm", .comparisons = {ComparedRows{.agreement = 90.0}}}};
  const std::vector<std::string> doubts = doubts_of(result);
  REQUIRE(doubts.size() == 2);
  CHECK_THAT(doubts[0],
             Contains("the standard error of b2, 2.5e+02, is more than a hundred times its value, 2") &&
                 Contains("try other starts ('starts: 8') or bounds"));
  CHECK_THAT(doubts[1],
             Contains("the record 10 mm is described no better than by its mean (agreement -65 %)") &&
                 Contains("try other starts"));
}

TEST_CASE("a search that ends at the mean of the record is doubted, and never sent to fix a parameter") {
  // One step from start 1 of BoxBOD ends far from the minimum.
  const FitResult result = fit_text(nist_diagram(small_set("BoxBOD"), 0, "  iterations: 1\n"));
  CHECK_FALSE(result.converged);
  std::string all;
  for (const std::string& finding : result.findings) all += finding + "\n";
  CHECK_THAT(all, Contains("no better than by its mean") && !Contains("fix"));
}

namespace {

/// The file of a fit of a exp(-b t) + c to 5 exp(-t/2) + 1 with a small disturbance.
std::string decay_from(const std::string& a, const std::string& b, const std::string& c,
                       const std::string& bounds = "") {
  return "step: 0.25 s\nstop: 9.75 s\nparameters: {a: " + a + ", b: " + b + ", c: " + c +
         "}\nfit:\n  parameters: {a: {start: " + a + bounds + "}, b: {start: " + b + "}, c: {start: " + c +
         bounds + "}}\n  compare: [{model: m, measured: y}]\n" +
         R"yaml(blocks:
  t: {block: Ramp, slope: 1}
  y: {block: Expression, u: t, expression: "5*exp(-u/2) + 1 + 0.05*sin(37*u)"}
  m: {block: Expression, u: t, expression: "$a*exp(-$b*u) + $c"}
units: {t: "1", y: "1", m: "1"}
record: [m, y]
)yaml";
}

}  // namespace

// scipy 1.10.1: least_squares(lambda p: p[0]*exp(-p[1]*t)+p[2]-y, [-5,3,1], xtol=1e-15), t = arange(40)/4
TEST_CASE("a search that a steep start has made slow is not at a minimum, and does not say so") {
  for (const char* a : {"-1", "1"}) {
    const FitResult steep = fit_text(decay_from(a, "-3", "1"));
    CHECK_FALSE(steep.converged);
    CHECK(steep.astray);
    REQUIRE(!steep.findings.empty());
    CHECK_THAT(steep.findings.front(), Contains("where the search has ended") || Contains("no minimum"));
  }
  const FitResult good = fit_text(decay_from("-5", "3", "1"));
  CHECK(good.converged);
  CHECK_FALSE(good.astray);
  CHECK(digits(found(good, "a").value, 5.0002484587) > 7.0);
  CHECK(digits(found(good, "b").value, 0.500520468148) > 7.0);
  CHECK(digits(found(good, "c").value, 1.00136144596) > 7.0);
}

// From there scipy ends at c = 20 with a = -16.168 and b = -0.0210, the minimum on that bound.
TEST_CASE("a search that ends at a bound begins again inside of it, and finds the better minimum") {
  const FitResult result = fit_text(decay_from("1", "-3", "1", ", bounds: [-20, 20]"));
  CHECK(result.converged);
  CHECK_FALSE(found(result, "c").at_bound);
  CHECK(digits(found(result, "a").value, 5.0002484587) > 6.0);
  CHECK(digits(found(result, "b").value, 0.500520468148) > 6.0);
  CHECK(digits(found(result, "c").value, 1.00136144596) > 6.0);
}

TEST_CASE("the note on a search that has ended at no minimum names the parameters") {
  CHECK_THAT(falling_text({{0, 0.19}, {2, 0.26}}, {"a", "b", "c"}),
             Contains("no minimum: the search has ended where the cost still falls along a, c (cosine") &&
                 Contains("up to 0.26") && Contains("try other starts"));
}

TEST_CASE("rows of a diagram without memory have classical errors, with a note where they go together") {
  const FitResult result = fit_text(nist_diagram(small_set("Misra1a"), 1));
  CHECK(result.standard_errors == StandardErrors::classical);
  CHECK(std::isnan(found(result, "b1").serial_error));
  CHECK(result.together > 0);
  REQUIRE(!result.findings.empty());
  CHECK_THAT(result.findings.back(), Contains("'standard_errors: serial' allows for it"));
}

TEST_CASE("the file chooses the standard errors of the intervals") {
  const FitResult series = fit_text(nist_diagram(small_set("Misra1a"), 1, "  standard_errors: serial\n"));
  const FittedNumber& one = found(series, "b1");
  CHECK(one.standard_error == one.serial_error);
  CHECK(one.serial_error > 1.1 * one.classical_error);
  CHECK(digits(one.classical_error, small_set("Misra1a").errors[0]) > 5.0);
}

TEST_CASE("a tolerance decides how far a search goes") {
  const NistSet set = small_set("MGH09");
  const auto exact = [&](const std::string& tolerance) {
    return digits(found(fit_text(nist_diagram(set, 1, "  tolerance: " + tolerance + "\n")), "b1").value,
                  set.certified[0]);
  };
  CHECK(exact("0.05") < exact("1e-9"));
  CHECK(exact("1e-9") > 7.0);
  CHECK_THAT(fit_error(straight_line(line + "  tolerance: 0\n")), Contains("tolerance"));
  CHECK_THAT(fit_error(straight_line(line + "  standard_errors: wide\n")), Contains("serial"));
}

}  // namespace stepwire::estimation
