#include "engine/analyse/estimation/certainty.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire::estimation {

namespace {

const std::vector<std::string> names{"A", "alpha", "c"};

}  // namespace

TEST_CASE("a direction of two is their product or their ratio") {
  CHECK(in_words(Eigen::Vector3d(1.0, -1.0, 0.0), names) ==
        "only the product of A and alpha can be known; fix one of them");
  CHECK(in_words(Eigen::Vector3d(1.0, 1.0, 0.001), names) ==
        "only the ratio of A and alpha can be known; fix one of them");
}

TEST_CASE(
    "two equally large unknowns whose product and sum have the same derivatives are told from no product") {
  // f = (a + b)*x and f = a*b*x have derivatives in one ratio where a = b.
  CHECK(in_words(Eigen::Vector3d(1.0, -1.0, 0.0), names, false, Eigen::Vector3d(2.0, 2.0, 9.0)) ==
        "only the product or sum of A and alpha can be known, which are equally large; fix one of them");
  CHECK(in_words(Eigen::Vector3d(1.0, -1.0, 0.0), names, false, Eigen::Vector3d(2.0, 3.0, 9.0)) ==
        "only the product of A and alpha can be known; fix one of them");
  CHECK(in_words(Eigen::Vector3d(1.0, 1.0, 0.0), names, false, Eigen::Vector3d(2.0, 2.0, 9.0)) ==
        "only the ratio or difference of A and alpha can be known, which are equally large; fix one of them");
}

TEST_CASE("a direction of one against several is their products, any other is shown with its parts") {
  CHECK(in_words(Eigen::Vector3d(1.0, -1.0, -1.0), names) ==
        "only the products of A with alpha and c can be known; fix one of them");
  CHECK(in_words(Eigen::Vector3d(1.0, -0.5, 0.0), names) ==
        "only combinations of A and alpha can be known, since A +1 % and alpha -0.5 % together change "
        "nothing; fix one of them");
}

TEST_CASE(
    "a number that the search has lost sends to other starts, and so does a direction that the start knew") {
  CHECK(in_words(Eigen::Vector3d(0.0, 0.0, 1.0), names) ==
        "c moves nothing that is compared where the search has ended; try other starts ('starts: 8') or "
        "bounds");
  CHECK(
      in_words(Eigen::Vector3d(1.0, -1.0, 0.0), names, true) ==
      "only combinations of A and alpha can be known where the search has ended, but each at its start; try "
      "other starts ('starts: 8') or bounds");
}

TEST_CASE("what is known beside a product keeps its error, and the product's members have none") {
  // r = 2 a b + c t - y at a = 3, b = -5: both columns are multiples of one another.
  Eigen::Matrix<double, 5, 3, Eigen::RowMajor> jacobian;
  Eigen::VectorXd residuals(5);
  for (int t = 0; t < 5; ++t) {
    jacobian.row(t) << 2.0 * -5.0, 2.0 * 3.0, t;
    residuals[t] = t % 2 == 0 ? 0.1 : -0.1;
  }
  const Certainty certainty = certainty_of(residuals, jacobian, Eigen::Vector3d(3.0, -5.0, 1.0), 3.0, {{0}});
  CHECK(std::isnan(certainty.standard_errors[0]));
  CHECK(std::isnan(certainty.standard_errors[1]));
  // The slope of a straight line over t = 0 to 4, whose sum of squares about the mean is 10.
  CHECK(certainty.standard_errors[2] == Approx(std::sqrt(0.05 / 3.0 / 10.0)));
  REQUIRE(certainty.free_directions.size() == 1);
  CHECK(in_words(certainty.free_directions[0], names) ==
        "only the product of A and alpha can be known; fix one of them");
}

TEST_CASE("independent rows have classical errors alone, and a series has both kinds") {
  // A mean of 48 rows whose residuals keep their sign for six rows.
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> ones =
      Eigen::MatrixXd::Ones(48, 1);
  Eigen::VectorXd residuals(48);
  for (int t = 0; t < 48; ++t) residuals[t] = t / 6 % 2 == 0 ? 1.0 : -1.0;
  const double classical = std::sqrt(48.0 / 47.0 / 48.0);  // s over the root of the rows
  const Certainty rows = certainty_of(residuals, ones, Eigen::VectorXd::Ones(1), 47.0, {{0}, false});
  CHECK(rows.classical[0] == Approx(classical));
  CHECK(rows.standard_errors[0] == Approx(classical));
  CHECK(rows.of_series.size() == 0);
  const Certainty series = certainty_of(residuals, ones, Eigen::VectorXd::Ones(1), 47.0, {{0}, true});
  CHECK(series.serial.rows > 0);
  CHECK(series.classical[0] == Approx(classical));
  CHECK(series.of_series[0] != Approx(classical));
  CHECK(series.standard_errors[0] == series.of_series[0]);
  const Certainty chosen =
      certainty_of(residuals, ones, Eigen::VectorXd::Ones(1), 47.0, {{0}, true, StandardErrors::classical});
  CHECK(chosen.standard_errors[0] == Approx(classical));
  CHECK(chosen.of_series[0] == series.of_series[0]);
}

}  // namespace stepwire::estimation
