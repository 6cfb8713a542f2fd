#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/paired_test.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Reference numbers from R 4.2.2; each test contains its command.

namespace stepwire::statistics {

namespace {

/// sleep$extra[11:20] - sleep$extra[1:10]
std::vector<double> slept_longer() {
  const auto values = textbook::sleep().values;
  std::vector<double> differences;
  for (std::size_t i = 0; i < 10; ++i) differences.push_back(values[i + 10] - values[i]);
  return differences;
}

const std::vector<double> tied{1, -1, 2, 2, -3, 0, 4, 4, 4, 5};

}  // namespace

TEST_CASE("the paired t of Student's sleep data is that of R") {
  // d <- sleep$extra[11:20] - sleep$extra[1:10]; t.test(d); sd(d)
  const PairedTest test = paired_test(slept_longer());
  CHECK(test.mean == Approx(1.58).epsilon(1e-12));
  CHECK(test.deviation == Approx(1.22999548327988).epsilon(1e-12));
  CHECK(test.freedom == 9.0);
  CHECK(test.t == Approx(4.06212768338204).epsilon(1e-12));
  CHECK(test.p == Approx(0.00283289019738427).epsilon(1e-11));
  CHECK(test.interval.low == Approx(0.700114236723018).epsilon(1e-11));
  CHECK(test.interval.high == Approx(2.45988576327698).epsilon(1e-11));
}

TEST_CASE("equal differences and a single one have no t") {
  const PairedTest equal = paired_test({0.1 + 0.2, 0.3, 0.3});
  CHECK(equal.deviation == 0.0);
  CHECK(std::isnan(equal.t));
  CHECK(std::isnan(equal.p));
  CHECK(equal.interval.low == equal.interval.high);
  const PairedTest alone = paired_test({0.3});
  CHECK(alone.mean == 0.3);
  CHECK(std::isnan(alone.interval.low));
  CHECK(std::isnan(paired_test({}).mean));
}

TEST_CASE("two subjects have a t with one degree of freedom") {
  // t.test(c(1, 2))
  const PairedTest two = paired_test({1.0, 2.0});
  CHECK(two.t == Approx(3.0));
  CHECK(two.p == Approx(0.204832764699133).epsilon(1e-12));
  CHECK(two.interval.high == Approx(7.85310236808735).epsilon(1e-12));
}

TEST_CASE("probabilities are corrected for their number as R does") {
  // p.adjust(c(0.01, 0.04, 0.03, 0.005, NA, 0.5), "holm")
  const auto corrected = holm_corrected({0.01, 0.04, 0.03, 0.005, no_number, 0.5});
  const std::vector<double> expected{0.040, 0.090, 0.090, 0.025, no_number, 0.500};
  REQUIRE(corrected.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (i == 4)
      CHECK(std::isnan(corrected[i]));
    else
      CHECK(corrected[i] == Approx(expected[i]).epsilon(1e-12));
  }
  CHECK(holm_corrected({0.6, 0.7}) == std::vector<double>{1.0, 1.0});
  CHECK(holm_corrected({}).empty());
}

TEST_CASE("signed ranks without ties have the exact probability of R") {
  // Hollander and Wolfe, depression: x <- c(1.83,0.50,1.62,2.48,1.68,1.88,1.55,3.06,1.30)
  // y <- c(0.878,0.647,0.598,2.05,1.06,1.29,1.06,3.14,1.29); wilcox.test(x - y)
  const std::vector<double> x{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30},
      y{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);
  const SignedRank test = signed_rank_test(differences);
  CHECK(test.sum == 40.0);
  CHECK(test.p == Approx(0.0390625).epsilon(1e-12));
  CHECK(test.exact);
}

TEST_CASE("signed ranks with ties and zeros are exact over all signs") {
  // d <- d[d != 0]; r <- rank(abs(d)); s <- as.matrix(expand.grid(rep(list(0:1), length(d)))) %*% r
  // v <- sum(r[d > 0]); mean(abs(s - sum(r)/2) >= abs(v - sum(r)/2))
  const SignedRank sleep = signed_rank_test(slept_longer());
  CHECK(sleep.count == 9);
  CHECK(sleep.sum == 45.0);
  CHECK(sleep.p == Approx(0.00390625).epsilon(1e-12));
  const SignedRank test = signed_rank_test(tied);
  CHECK(test.sum == 38.5);
  CHECK(test.p == Approx(0.05859375).epsilon(1e-12));
}

TEST_CASE("signed ranks of many differences follow the normal distribution as R does") {
  // wilcox.test(warpbreaks$breaks - 22.25, exact=FALSE); wilcox.test(c(1,-1,2,2,-3,0,4,4,4,5), exact=FALSE)
  std::vector<double> breaks = textbook::warps().values;
  for (double& value : breaks) value -= 22.25;
  const SignedRank many = signed_rank_test(breaks);
  CHECK_FALSE(many.exact);
  CHECK(many.sum == 1047.0);
  CHECK(many.p == Approx(0.00884175483676744).epsilon(1e-11));
  CHECK(signed_rank_test(tied, 0).p == Approx(0.0648888461851507).epsilon(1e-11));
}

TEST_CASE("signed ranks of zeros alone have no probability") {
  CHECK(std::isnan(signed_rank_test({0.0, 0.0}).p));
  CHECK(signed_rank_test({1.0, 1.0}).p == 0.5);
  CHECK(signed_rank_test({1.0}).p == 1.0);
}

}  // namespace stepwire::statistics
