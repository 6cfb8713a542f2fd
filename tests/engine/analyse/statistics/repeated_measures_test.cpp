#include "engine/analyse/statistics/repeated_measures.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Reference numbers from R 4.2.2; each test contains its command. The probability of Mauchly's W follows
// Box's expansion with the number of contrasts p throughout. R's mauchly.test has the number of cells in one
// place (0.0437 and 0.0217 below).
//
//   f <- function(W, p, n) { rho <- 1 - (2*p^2+p+2)/(6*p*n)
//     w2 <- (p+2)*(p-1)*(p-2)*(2*p^3+6*p^2+3*p+2)/(288*(n*p*rho)^2); z <- -n*rho*log(W); d <- p*(p+1)/2-1
//     a <- pchisq(z, d, lower=FALSE); a + w2*(pchisq(z, d+4, lower=FALSE) - a) }

namespace stepwire::statistics {
using namespace textbook;
using Catch::Matchers::Contains;

TEST_CASE("the drugs of Student's sleep data differ as R says") {
  // summary(aov(extra ~ group + Error(ID/group), sleep))
  const Anova all = repeated_measures(sleep(), {"group"}, "ID");
  const AnovaRow& group = *all.find("group");
  CHECK(group.f == Approx(16.50088).epsilon(3e-7));
  CHECK(group.p == Approx(0.0028329).epsilon(1e-5));
  CHECK(group.against == "group:ID");
  CHECK(all.find("group:ID")->freedom == 9.0);
  CHECK_FALSE(group.sphericity.has_value());
}

TEST_CASE("F of two conditions is the square of the paired t") {
  const Observations data = sleep();
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < 10; ++i) {
    const double difference = data.values[i + 10] - data.values[i];
    sum += difference, squares += difference * difference;
  }
  const double variance = (squares - sum * sum / 10.0) / 9.0, t = sum / 10.0 / std::sqrt(variance / 10.0);
  CHECK(repeated_measures(data, {"group"}, "ID").find("group")->f == Approx(t * t).epsilon(1e-12));
}

TEST_CASE("four stools are told apart, and are not spherical") {
  // e <- ergoStool[order(ergoStool$Subject, ergoStool$Type),]; summary(aov(effort ~ Type +
  // Error(Subject/Type), e)) m <- lm(matrix(e$effort, ncol=4, byrow=TRUE) ~ 1); anova(m, X=~1,
  // test="Spherical"); mauchly.test(m, X=~1)
  const Anova all = repeated_measures(stools(), {"Type"}, "Subject");
  const AnovaRow& type = *all.find("Type");
  CHECK(type.f == Approx(22.35564).epsilon(3e-7));
  CHECK(type.p == Approx(3.9345638094e-07).epsilon(1e-9));
  REQUIRE(type.sphericity.has_value());
  CHECK(type.sphericity->epsilon == Approx(0.6459).margin(5e-5));
  CHECK(type.sphericity->p_corrected == Approx(3.00556383917e-05).epsilon(1e-9));
  // g <- Greenhouse-Geisser epsilon: (9*3*g - 2) / (3 * (8 - 3*g)), which anova prints as 0.8490
  CHECK(type.sphericity->huynh_feldt == Approx(0.848965071025377).epsilon(1e-9));
  CHECK(type.sphericity->p_huynh_feldt == Approx(2.48308895121e-06).epsilon(1e-9));
  CHECK(type.sphericity->mauchly == Approx(0.1796005467).epsilon(1e-9));
  CHECK(type.sphericity->p_mauchly == Approx(0.043647965565).epsilon(1e-8));
  REQUIRE(all.warnings.size() == 1);
  CHECK_THAT(
      all.warnings[0],
      Contains("'Type' is not spherical (Mauchly's P 0.044); its Greenhouse-Geisser epsilon is 0.646"));
}

TEST_CASE("two factors within subjects are compared each with its own interaction") {
  // summary(aov(Y ~ N*V + Error(B/(N*V)), oats))
  // m <- lm(matrix(o$Y, nrow=6, byrow=TRUE) ~ 1), o ordered by B, V, N.
  // Sphericity: id <- expand.grid(N=factor(1:4), V=factor(1:3))
  // anova(m, idata=id, X=~V, M=~V+N, test="Spherical"); for V: X=~N; for N:V: X=~V+N, M=~V*N
  // mauchly.test(m, idata=id, X=~V, M=~V+N)
  const Anova all = repeated_measures(oats(), {"V", "N"}, "B");
  CHECK(all.find("N")->f == Approx(55.98052).epsilon(2e-7));
  CHECK(all.find("N")->sphericity->epsilon == Approx(0.6492).margin(5e-5));
  CHECK(all.find("N")->sphericity->p_corrected == Approx(4.85548414103e-06).epsilon(1e-9));
  CHECK(all.find("N")->sphericity->p_mauchly == Approx(0.0208734854549).epsilon(1e-8));
  CHECK(all.find("V")->sphericity->p_mauchly == Approx(0.512159409).epsilon(1e-8));
  CHECK(all.find("V")->f == Approx(1.48534).epsilon(4e-6));
  CHECK(all.find("V")->sphericity->p_corrected == Approx(0.276759253167).epsilon(1e-10));
  CHECK(all.find("V:N")->f == Approx(0.26029).margin(6e-6));
  CHECK(all.find("V:N")->sphericity->p_corrected == Approx(0.868395261698).epsilon(1e-10));
  CHECK(std::isnan(all.find("V:N")->sphericity->mauchly));
}

TEST_CASE("two subjects leave Huynh and Feldt's epsilon open, and equal scores all of sphericity") {
  const std::vector<Factor> factors{running("condition", 3, 1, 6), running("subject", 2, 3, 6, true)};
  const Anova two = repeated_measures({"error", {1, 2, 4, 1, 3, 9}, factors}, {"condition"}, "subject");
  CHECK(std::isnan(two.find("condition")->sphericity->huynh_feldt));
  CHECK(two.find("condition")->sphericity->epsilon == Approx(0.5));
  const Anova equal = repeated_measures({"error", {1, 2, 4, 2, 3, 5}, factors}, {"condition"}, "subject");
  CHECK_FALSE(equal.find("condition")->sphericity.has_value());
  REQUIRE(equal.warnings.size() == 1);
  CHECK_THAT(equal.warnings[0], Contains("F of condition has no value"));
}

TEST_CASE("a test that rejects nothing does not call a term aspherical") {
  // Python: S = cov of the scores times orthonormal contrasts; epsilon = tr(S)^2/(2 tr(S S));
  // W = det(S)/(tr(S)/2)^2; chi2.sf(-(n-1)*(1-12/(12*(n-1)))*log(W), 2), n = 4
  const std::vector<Factor> factors{running("condition", 3, 1, 12), running("subject", 4, 3, 12, true)};
  const std::vector<double> scores{1, 2, 4, 1, 3, 9, 2, 2, 5, 1, 4, 6};
  const Anova all = repeated_measures({"error", scores, factors}, {"condition"}, "subject");
  REQUIRE(all.warnings.size() == 1);
  CHECK_THAT(all.warnings[0],
             Contains("Mauchly's test does not reject that 'condition' is spherical (P 0.61)") &&
                 Contains("its Greenhouse-Geisser epsilon is 0.718: read the corrected P"));
}

TEST_CASE("several trials of one subject in one cell count as their mean") {
  Observations twice = sleep();
  const Observations once = twice;
  for (std::size_t i = 0; i < once.values.size(); ++i) {
    twice.values[i] += 0.3;
    twice.values.push_back(once.values[i] - 0.3);
    for (Factor& factor : twice.factors) factor.level.push_back(factor.level[i]);
  }
  CHECK(repeated_measures(twice, {"group"}, "ID").find("group")->f ==
        Approx(repeated_measures(once, {"group"}, "ID").find("group")->f).epsilon(1e-10));
}

TEST_CASE("a design that is not complete is refused with the cell that is missing") {
  Observations some = sleep();
  some.values.pop_back();
  for (Factor& factor : some.factors) factor.level.pop_back();
  CHECK_THROWS_WITH(repeated_measures(some, {"group"}, "ID"),
                    Contains("the design is not complete: there is no value for ID 10, group 2"));
  const Observations alone{
      "error", {1.0, 2.0}, {running("condition", 2, 1, 2), running("subject", 1, 1, 2, true)}};
  CHECK_THROWS_WITH(repeated_measures(alone, {"condition"}, "subject"), Contains("two subjects or more"));
}

TEST_CASE("groups of unequal size are compared between subjects, and occasions within them") {
  // Numbers of numpy 1.24 and scipy 1.10: least squares of the four occasions' orthonormal contrasts on a
  // constant and two columns that sum to zero (type III), and f_oneway of the subjects' means.
  const std::vector<double> scores{0,    3,    12,  10,   7.5,  15.5, 12.5, 4.5, 15,   11,   2,    16,
                                   5.5,  12.5, 8.5, 16.5, 13,   10,   2,    17,  3.5,  11.5, 8.5,  11.5,
                                   8,    4,    12,  9,    15.5, 7.5,  5.5,  9.5, 6,    3,    12,   4,
                                   13.5, 4.5,  1.5, 4.5,  4,    17,   8,    16,  11.5, 18.5, 14.5, 16.5};
  std::vector<std::string> groups;
  for (int subject = 0; subject < 12; ++subject)
    for (int k = 0; k < 4; ++k) groups.emplace_back(subject < 4 ? "a" : subject < 7 ? "b" : "c");
  const Observations data{
      "score",
      scores,
      {make_factor("group", groups), running("time", 4, 1, 48), running("who", 12, 4, 48, true)}};
  const Anova all = repeated_measures(data, {"time"}, "who", {"group"});
  CHECK(all.find("group")->f == Approx(0.02600694064925129).epsilon(1e-10));
  CHECK(all.find("group")->p == Approx(0.9744012709067388).epsilon(1e-10));
  CHECK(all.find("group")->against == "who");
  CHECK(all.find("who")->freedom == 9.0);
  const AnovaRow &time = *all.find("time"), &both = *all.find("group:time");
  CHECK(time.sum_of_squares == Approx(77.24042553191475).epsilon(1e-12));
  CHECK(time.f == Approx(0.8928382093337182).epsilon(1e-10));
  CHECK(time.against == "time:who");
  CHECK(both.f == Approx(0.24710217056254855).epsilon(1e-10));
  CHECK(both.p == Approx(0.9562899199350239).epsilon(1e-10));
  REQUIRE(both.sphericity.has_value());
  CHECK(both.sphericity->epsilon == Approx(0.8245357485775276).epsilon(1e-10));
  CHECK(both.sphericity->p_corrected == Approx(0.9356531537119656).epsilon(1e-10));
  CHECK(time.sphericity->mauchly == Approx(0.6745762530129663).epsilon(1e-10));
  CHECK_FALSE(all.balanced);
}

TEST_CASE("a subject under two levels of a factor between subjects is refused by name") {
  CHECK_THROWS_WITH(repeated_measures(sleep(), {}, "ID", {"group"}),
                    Contains("ID 1 has values under two levels of 'group', 1 and 2"));
}

}  // namespace stepwire::statistics
