#include "engine/analyse/statistics/paired_test.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/condition_table.hpp"
#include "engine/analyse/statistics/distributions.hpp"
#include "engine/analyse/statistics/repeated_measures.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Reference numbers from R 4.2.2; each test contains its command. R's noncentral F has nine correct digits.

namespace stepwire::statistics {
using namespace textbook;

namespace {

ConditionTable sleep_table() {
  return condition_table(sleep(), "group", "ID", {"1", "2"});
}

/// lambda / (lambda + df1 + df2 + 1), as R writes it below.
ConfidenceInterval eta_interval(double f, double above, double below) {
  const ConfidenceInterval lambda = noncentrality_of_f(f, above, below);
  const double rest = above + below + 1.0;
  return {lambda.low / (lambda.low + rest), lambda.high / (lambda.high + rest)};
}

}  // namespace

TEST_CASE("Cohen's d of the sleep data has the value and the limits of R") {
  // d <- sleep$extra[11:20] - sleep$extra[1:10]; t <- mean(d) / sd(d) * sqrt(10);
  // Limits: f <- function(p) uniroot(function(x) pt(t, 9, x) - p, c(-37, 37), tol=1e-13)$root
  // c(mean(d) / sd(d), f(.975) / sqrt(10), f(.025) / sqrt(10));
  // By the mean deviation: mean(d) / ((sd(sleep$extra[1:10]) + sd(sleep$extra[11:20])) / 2)
  const ConditionTable table = sleep_table();
  const PairedEffect effect = paired_effect(table.column(1), table.column(0));
  CHECK(effect.d_z == Approx(1.28455756259106).epsilon(1e-12));
  CHECK(effect.interval.low == Approx(0.414627756380144).epsilon(1e-9));
  CHECK(effect.interval.high == Approx(2.11801651397707).epsilon(1e-9));
  CHECK(effect.d_av == Approx(0.833496341312704).epsilon(1e-12));
  const PairedEffect reversed = paired_effect(table.column(0), table.column(1));
  CHECK(reversed.d_z == -effect.d_z);
  CHECK(reversed.interval.low == Approx(-effect.interval.high).epsilon(1e-9));
}

TEST_CASE("the noncentralities of small t are those of R") {
  // f as above with t, df: -0.4, 4 and 3, 1
  const ConfidenceInterval small = noncentrality_of_t(-0.4, 4);
  CHECK(small.low / std::sqrt(5.0) == Approx(-1.05301383496604).epsilon(1e-9));
  CHECK(small.high / std::sqrt(5.0) == Approx(0.71628517124718).epsilon(1e-9));
  const ConfidenceInterval two = noncentrality_of_t(3.0, 1);
  CHECK(two.low / std::sqrt(2.0) == Approx(-0.653932955962248).epsilon(1e-9));
  CHECK(two.high / std::sqrt(2.0) == Approx(5.01192886385354).epsilon(1e-9));
}

TEST_CASE("a t far out has limits on both sides of it, and one that is not finite has none") {
  const ConfidenceInterval far = noncentrality_of_t(250.0, 9);
  CHECK((far.low < 250.0 && 250.0 < far.high));
  CHECK(std::isnan(noncentrality_of_t(1e12, 9).low));
  CHECK(std::isnan(noncentrality_of_t(INFINITY, 9).low));
  CHECK(std::isnan(noncentrality_of_f(1e20, 1, 9).low));
  CHECK(std::isnan(noncentrality_of_f(NAN, 1, 9).high));
}

TEST_CASE("conditions that differ by a constant have no d_z, and constant ones no d at all") {
  const PairedEffect shifted = paired_effect({1.5, 2.5, 3.5}, {1.0, 2.0, 3.0});
  CHECK(std::isnan(shifted.d_z));
  CHECK(std::isnan(shifted.interval.low));
  CHECK(shifted.d_av == Approx(0.5));
  CHECK(std::isnan(paired_effect({1.0, 1.0}, {2.0, 2.0}).d_av));
}

TEST_CASE("eta squared of four stools has the values and the limits of R") {
  // a <- anova(lm(effort ~ Type + Subject, ergoStool)); S <- a[, "Sum Sq"]
  // S[1] / (S[1] + S[3]); S[1] / sum(S);
  // Limits: f <- function(p) if (pf(F, a, b) < p) 0
  //   else uniroot(function(x) pf(F, a, b, x) - p, c(0, 1000), tol=1e-12)$root
  // l <- c(f(.95), f(.05)); l / (l+a+b+1)
  const auto effects = term_effects(repeated_measures(stools(), {"Type"}, "Subject"));
  REQUIRE(effects.size() == 1);
  CHECK(effects[0].term == "Type");
  CHECK(effects[0].partial == Approx(0.736457545981355).epsilon(1e-12));
  CHECK(effects[0].interval.low == Approx(0.512693489716524).epsilon(1e-7));
  CHECK(effects[0].interval.high == Approx(0.799687717852063).epsilon(1e-7));
  CHECK(effects[0].generalised == Approx(0.459374508879459).epsilon(1e-12));
}

TEST_CASE("eta squared of the sleep data counts all that varies between subjects") {
  // s <- anova(lm(extra ~ group + ID, sleep)); S <- s[, "Sum Sq"]; S[1] / (S[1] + S[3]); S[1] / sum(S)
  const auto effects = term_effects(repeated_measures(sleep(), {"group"}, "ID"));
  CHECK(effects[0].partial == Approx(0.647071021254536).epsilon(1e-12));
  CHECK(effects[0].generalised == Approx(0.161332850791025).epsilon(1e-12));
  CHECK(effects[0].interval.low == Approx(0.212376551103756).epsilon(1e-7));
  CHECK(effects[0].interval.high == Approx(0.779960645518147).epsilon(1e-7));
}

TEST_CASE("limits of eta squared of small F begin at zero") {
  CHECK(eta_interval(0.5, 2, 10).low == 0.0);
  CHECK(eta_interval(0.5, 2, 10).high == Approx(0.291029495328446).epsilon(1e-7));
  CHECK(eta_interval(4.2, 1, 9).low == 0.0);
  CHECK(eta_interval(4.2, 1, 9).high == Approx(0.570354218697481).epsilon(1e-7));
}

TEST_CASE("intervals of means are those of R, with and without what subjects share") {
  // e <- matrix(ergoStool$effort, ncol=4, byrow=TRUE), ordered by Subject and Type; sapply(1:4, function(k)
  // t.test(e[, k])$conf.int); N <- e - rowMeans(e) + mean(e)
  // h <- qt(.975, 8) * apply(N, 2, sd) / sqrt(9) * sqrt(4 / 3); cbind(colMeans(e) - h, colMeans(e) + h)
  const auto found =
      mean_intervals(condition_table(stools(), "Type", "Subject", {"1", "2", "3", "4"}).values);
  REQUIRE(found.size() == 4);
  CHECK(found[0].mean == Approx(8.55555555555556).epsilon(1e-12));
  CHECK(found[0].plain.low == Approx(7.27444214710880).epsilon(1e-11));
  CHECK(found[3].plain.high == Approx(10.54120920442493).epsilon(1e-11));
  CHECK(found[0].within_subject.low == Approx(7.54612815344828).epsilon(1e-11));
  CHECK(found[1].within_subject.high == Approx(13.20326310360714).epsilon(1e-11));
  CHECK(found[3].within_subject.low == Approx(8.41113139145259).epsilon(1e-11));
}

TEST_CASE("one condition has no interval within subjects") {
  const auto alone = mean_intervals(Eigen::Vector3d(1.0, 2.0, 4.0));
  CHECK(std::isfinite(alone[0].plain.low));
  CHECK(std::isnan(alone[0].within_subject.low));
}

}  // namespace stepwire::statistics
