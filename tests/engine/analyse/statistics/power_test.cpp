#include "engine/analyse/statistics/power.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/condition_table.hpp"
#include "engine/analyse/statistics/contrasts.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Reference numbers from R 4.2.2; each test contains its command.

namespace stepwire::statistics {
using namespace textbook;

namespace {

/// sleep$extra[11:20] - sleep$extra[1:10], a column.
Eigen::MatrixXd slept_longer() {
  const auto differences = condition_table(sleep(), "group", "ID", {"2", "1"}).differences(0, 1);
  return Eigen::Map<const Eigen::VectorXd>(differences.data(), 10);
}

Eigen::MatrixXd stool_scores() {
  return cell_means(stools(), {"Type"}, "Subject") * contrasts_of({"Type"}, stools(), {"Type"});
}

constexpr std::size_t many = 40000;
constexpr double sure = 0.01;  // four standard errors of a share of `many` samples

}  // namespace

TEST_CASE("the power of paired t tests is that of R") {
  // power.t.test(n=5, delta=0.5, sd=1, type="paired", strict=TRUE)$power, then the others
  CHECK(paired_power(0.5, 5) == Approx(0.140516689990415).epsilon(1e-9));
  CHECK(paired_power(1.2, 10) == Approx(0.920333385589917).epsilon(1e-9));
  CHECK(paired_power(0.3, 20) == Approx(0.247089089968522).epsilon(1e-9));
  CHECK(paired_power(3.0, 2) == Approx(0.260770714229384).epsilon(1e-9));
  CHECK(paired_power(0.5, 34) == Approx(0.80777750127944).epsilon(1e-9));
  CHECK(paired_power(-0.5, 34) == paired_power(0.5, 34));
  CHECK(paired_power(0.0, 12) == Approx(0.05).epsilon(1e-9));
  CHECK(std::isnan(paired_power(NAN, 12)));
}

TEST_CASE("the subjects needed are those of R, the next whole number") {
  // power.t.test(delta=0.5, sd=1, power=0.8, type="paired", strict=TRUE)$n: 33.37, 7.588, 198.2, 3.144, 6.913
  // power=0.9: 44.00 (43.9955)
  CHECK(subjects_needed(0.5) == 34);
  CHECK(subjects_needed(1.2) == 8);
  CHECK(subjects_needed(-0.2) == 199);
  CHECK(subjects_needed(3.0) == 4);
  CHECK(subjects_needed(1.28456) == 7);
  CHECK(subjects_needed(0.5, 0.9) == 44);
}

TEST_CASE("no number of subjects shows an effect of nothing") {
  CHECK_FALSE(subjects_needed(0.0).has_value());
  CHECK_FALSE(subjects_needed(NAN).has_value());
  CHECK_FALSE(subjects_needed(0.1, 0.8, 100).has_value());
  CHECK(subjects_needed(40.0) == 2);
  CHECK(paired_power(1e12, 2) == 1.0);
}

TEST_CASE("simulated power of two conditions is the share of all samples that can be drawn") {
  // d <- sleep$extra[11:20] - sleep$extra[1:10]; q <- mean(d) + (d - mean(d)) * sqrt(10/9);
  // All samples: x <- matrix(q[as.matrix(expand.grid(rep(list(1:10), n)))], ncol=n); m <- rowMeans(x)
  // s <- sqrt(rowSums((x - m)^2) / (n-1)); mean(s > 1e-9 & abs(m) * sqrt(n) > qt(.975, n-1) * s)
  const auto power = simulated_power(slept_longer(), {1, many, 5});
  REQUIRE(power.size() == 6);
  CHECK(power[1] == 0.0);
  CHECK(power[3] == Approx(0.3720).margin(sure));
  CHECK(power[4] == Approx(0.4422).margin(sure));
  CHECK(power[5] == Approx(0.6951).margin(sure));
}

TEST_CASE("simulated power of a factor of four levels is the share of all samples that can be drawn") {
  // M <- contr.helmert(4); M <- M %*% diag(1 / sqrt(colSums(M^2))); z <- e %*% M,
  // about its mean times sqrt(9/8).
  // Of every row i of expand.grid(rep(list(1:9), n)): b <- n * sum(colMeans(z[i, ])^2);
  // Share: w <- sum(z[i, ]^2) - b; w > 1e-9 && b / w * (n-1) > qf(.95, 3 * eps, 3 * (n-1) * eps)
  const auto uncorrected = simulated_power(stool_scores(), {1, many, 4});
  CHECK(uncorrected[3] == Approx(0.855967078189300).margin(sure));
  const auto corrected = simulated_power(stool_scores(), {1, many, 4, 0.645921444443657});
  CHECK(corrected[3] == Approx(0.547325102880658).margin(sure));
  CHECK(corrected[4] == Approx(0.978509373571102).margin(sure));
}

TEST_CASE("simulated power follows from its seed") {
  CHECK(simulated_power(slept_longer(), {1, 200, 8}) == simulated_power(slept_longer(), {1, 200, 8}));
  CHECK(simulated_power(slept_longer(), {1, 200, 8}) != simulated_power(slept_longer(), {2, 200, 8}));
}

TEST_CASE("two subjects and equal differences leave nothing to simulate") {
  CHECK(simulated_power(Eigen::Vector2d(1.0, 2.0)).empty());
  CHECK(simulated_power(Eigen::Vector3d(0.1 + 0.2, 0.3, 0.3)).empty());
}

TEST_CASE("the subjects needed are those from which on the power stays") {
  CHECK(subjects_needed(std::vector<double>{0.0, 0.0, 0.85, 0.7, 0.8, 0.9}) == 4);
  CHECK_FALSE(subjects_needed(std::vector<double>{0.0, 0.0, 0.9, 0.7}).has_value());
  CHECK_FALSE(subjects_needed(std::vector<double>{}).has_value());
}

}  // namespace stepwire::statistics
