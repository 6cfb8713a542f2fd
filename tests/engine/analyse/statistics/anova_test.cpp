#include "engine/analyse/statistics/anova.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Reference numbers from R 4.2.2; each test contains its command.

namespace stepwire::statistics {
using namespace textbook;
using Catch::Matchers::Contains;

namespace {

/// As many digits as R prints.
Approx printed(double value, double last_digit) {
  return Approx(value).epsilon(0.0).margin(0.51 * last_digit);
}

struct Expected {
  std::string term;
  double f, p;
};

void check(const Anova& anova, const std::vector<Expected>& all) {
  for (const Expected& expected : all) {
    INFO(expected.term);
    const AnovaRow* row = anova.find(expected.term);
    REQUIRE(row != nullptr);
    CHECK(row->f == printed(expected.f, 1e-5));
    CHECK(row->p == Approx(expected.p).epsilon(2e-5));
  }
}

/// NIST StRD, SmLs01 to 09: nine treatments whose means are 1.4, 1.3, 1.5, 1.3, ...; each has its mean and as
/// many values 0.1 below as above it. Certified: F = number of replicates, residual mean square 0.01.
Observations nist(std::size_t replicates, double offset) {
  const std::vector<int> tenths{14, 13, 15, 13, 15, 13, 15, 13, 15};
  Observations all{"response", {}, {running("treatment", 9, replicates, 9 * replicates)}};
  for (const int mean : tenths)
    for (std::size_t i = 0; i < replicates; ++i)
      all.values.push_back(offset + (mean + (i == 0 ? 0 : i % 2 == 1 ? -1 : 1)) / 10.0);
  return all;
}

/// Ten people under the five conditions of task 2: H, V, HV, V_gp, HV_gp.
Observations five_conditions() {
  const std::vector<std::array<const char*, 3>> conditions{{"yes", "no", "no"},
                                                           {"no", "yes", "no"},
                                                           {"yes", "yes", "no"},
                                                           {"no", "yes", "yes"},
                                                           {"yes", "yes", "yes"}};
  std::vector<std::string> haptic, visual, path;
  Observations all{"error", {}, {}};
  for (int i = 0; i < 50; ++i) {
    const auto& [h, v, g] = conditions[static_cast<std::size_t>(i % 5)];
    haptic.emplace_back(h), visual.emplace_back(v), path.emplace_back(g);
    all.values.push_back(std::sin(1.0 + 3.7 * i));
  }
  all.factors = {make_factor("haptic", haptic), make_factor("visual", visual), make_factor("path", path)};
  return all;
}

}  // namespace

TEST_CASE("two crossed factors agree with R on warpbreaks and ToothGrowth") {
  // summary(aov(breaks ~ wool*tension, warpbreaks)); summary(aov(len ~ supp*factor(dose), ToothGrowth))
  const Anova breaks = anova(warps(), crossed_terms({"wool", "tension"}));
  check(breaks, {{"wool", 3.76529, 0.05821298},
                 {"tension", 8.49805, 0.00069262},
                 {"wool:tension", 4.18907, 0.02104419}});
  CHECK(breaks.find("tension")->sum_of_squares == Approx(2034.25925926).epsilon(1e-11));
  CHECK(breaks.residual.sum_of_squares == Approx(5745.11111111).epsilon(1e-11));
  CHECK(breaks.residual.freedom == 48.0);
  CHECK(breaks.balanced);
  CHECK(breaks.design == "54 values in 6 cells of 9");
  CHECK(breaks.find("wool")->partial_eta_squared == Approx(450.66666667 / (450.66666667 + 5745.11111111)));
  const Anova length = anova(teeth(), crossed_terms({"supp", "dose"}));
  check(length, {{"supp", 15.57198, 0.00023118}, {"supp:dose", 4.10699, 0.02186027}});
  CHECK(length.find("dose")->f == printed(91.99996, 1e-5));
  CHECK(length.find("dose")->p < 2.22e-16);
}

TEST_CASE("blocks take a factor out, and the interaction that they hide is named") {
  // summary(aov(yield ~ N*P*K + Error(block), npk))
  auto terms = additive_terms({"block"});
  for (const Term& term : crossed_terms({"N", "P", "K"})) terms.push_back(term);
  const Anova yield = anova(peas(), terms);
  check(yield, {{"N", 12.25873, 0.0043718},
                {"P", 0.54413, 0.4749041},
                {"K", 6.16569, 0.0287951},
                {"N:P", 1.37830, 0.2631653},
                {"N:K", 2.14597, 0.1686479},
                {"P:K", 0.03119, 0.8627521}});
  CHECK(yield.find("N:P:K")->freedom == 0.0);
  CHECK(std::isnan(yield.find("N:P:K")->f));
  REQUIRE(yield.warnings.size() == 1);
  CHECK(yield.warnings[0] == "'N:P:K' cannot be estimated: in these data it follows from block");
}

TEST_CASE("a split plot compares the variety with whole plots and nitrogen with the rest") {
  // summary(aov(Y ~ N*V + Error(B/V), oats))
  const Anova yield =
      anova(oats(), {{{"B"}, {}}, {{"V"}, {"B", "V"}}, {{"B", "V"}, {}}, {{"N"}, {}}, {{"N", "V"}, {}}});
  check(yield, {{"V", 1.48534, 0.27239}, {"N", 37.68565, 2.4577e-12}, {"N:V", 0.30282, 0.9322}});
  CHECK(yield.find("V")->against == "B:V");
  CHECK(yield.residual.freedom == 45.0);
}

TEST_CASE("unequal cells give the sums of squares of types I, II and III") {
  // w <- warpbreaks[-c(1,2,20,33,54),]; options(contrasts=c("contr.sum","contr.poly"))
  // f <- aov(breaks ~ wool*tension, w); summary(f); drop1(f, .~., test="F")
  // drop1(aov(breaks ~ wool+tension, w), test="F")
  const auto terms = crossed_terms({"wool", "tension"});
  const Anova one = anova(unequal_warps(), terms, SumsOfSquares::sequential);
  check(one, {{"wool", 4.93785, 0.03158670}, {"tension", 10.00857, 0.00026991}});
  const Anova two = anova(unequal_warps(), terms, SumsOfSquares::hierarchical);
  CHECK(two.find("wool")->sum_of_squares == Approx(632.065758401).epsilon(1e-11));
  CHECK(two.find("tension")->sum_of_squares == Approx(2287.415480624).epsilon(1e-11));
  const Anova three = anova(unequal_warps(), terms, SumsOfSquares::partial);
  check(three, {{"wool", 6.81535, 0.01239087},
                {"tension", 10.60658, 0.00018016},
                {"wool:tension", 6.12415, 0.00456788}});
  CHECK_FALSE(three.balanced);
  CHECK(three.design == "49 values in 6 cells of 7 to 9");
}

TEST_CASE("the additive form leaves interactions to the residual") {
  // drop1(aov(breaks ~ wool+tension, warpbreaks[-c(1,2,20,33,54),]), test="F")
  const auto terms = additive_terms({"wool", "tension"});
  for (const auto sums : {SumsOfSquares::hierarchical, SumsOfSquares::partial}) {
    const Anova breaks = anova(unequal_warps(), terms, sums);
    check(breaks, {{"wool", 4.50519, 0.0393287}, {"tension", 8.15202, 0.0009523}});
    CHECK(breaks.residual.sum_of_squares == Approx(6313.38285271).epsilon(1e-11));
  }
}

TEST_CASE("NIST's sets SmLs01 to 06 keep ten digits and 07 to 09 what their decimals keep") {
  // Certified F: 21, 201, 2001 for 21, 201, 2001 replicates, whatever is added to all values.
  const std::vector<std::pair<double, double>> offsets{{0.0, 1e-11}, {1e6, 1e-8}, {1e12, 5e-3}};
  for (const std::size_t replicates : {21U, 201U, 2001U})
    for (const auto& [offset, digits] : offsets) {
      INFO(replicates << " replicates, offset " << offset);
      const Anova all = anova(nist(replicates, offset), additive_terms({"treatment"}));
      CHECK(all.terms[0].f == Approx(static_cast<double>(replicates)).epsilon(digits));
      CHECK(all.residual.mean_square == Approx(0.01).epsilon(digits));
    }
}

TEST_CASE("the additive form of task 2 estimates three factors from five of eight cells") {
  const Anova all = anova(five_conditions(), additive_terms({"haptic", "visual", "path"}));
  REQUIRE(all.warnings.size() == 1);  // the one interaction whose four combinations were observed
  CHECK_THAT(all.warnings[0], Contains("the interaction haptic:path is part of the residual"));
  CHECK(all.residual.freedom == 46.0);
  CHECK_FALSE(all.balanced);
  CHECK(all.design == "50 values in 5 cells of 10; 3 of 8 combinations were not observed");
}

TEST_CASE("interactions that five conditions cannot tell apart are named with what they follow from") {
  const Anova all = anova(five_conditions(), crossed_terms({"haptic", "visual", "path"}));
  REQUIRE(all.warnings.size() == 3);
  CHECK(all.warnings[0] ==
        "'haptic:visual' cannot be estimated: in these data it follows from haptic and visual");
  CHECK(all.warnings[1] ==
        "'visual:path' cannot be estimated: in these data it follows from visual and path");
  CHECK_THAT(all.warnings[2], Contains("'haptic:visual:path' cannot be estimated"));
  CHECK(all.find("haptic:path")->freedom == 1.0);
}

TEST_CASE("a level that is missing takes a degree of freedom from its interaction") {
  Observations some = warps();
  for (std::size_t i = some.values.size(); i-- > 45;) {  // no wool 2 with tension 3
    some.values.pop_back();
    for (Factor& factor : some.factors) factor.level.pop_back();
  }
  const Anova all = anova(some, crossed_terms({"wool", "tension"}));
  CHECK_THAT(all.warnings.at(0), Contains("'wool:tension' has 1 of its 2 degrees of freedom"));
}

TEST_CASE("variances that differ are told beside the table") {
  Observations two{"error", {}, {running("feedback", 2, 10, 20)}};
  for (int i = 0; i < 20; ++i) two.values.push_back((i < 10 ? 1.0 : 30.0) * std::sin(2.3 * i));
  const Anova all = anova(two, additive_terms({"feedback"}));
  REQUIRE(all.warnings.size() == 1);
  CHECK_THAT(all.warnings[0], Contains("the variances of the cells differ (Brown-Forsythe F(1, 18) ="));
}

TEST_CASE("what an analysis cannot work on is refused with the reason") {
  Observations some = warps();
  CHECK_THROWS_WITH(anova(some, additive_terms({"weather"})),
                    "there is no factor 'weather'; there are: wool, tension");
  CHECK_THROWS_WITH(anova(some, {{{"wool"}, {"tension"}}}),
                    "'wool' is compared with 'tension', which is no term of the model");
  some.values[7] = NAN;
  CHECK_THROWS_WITH(anova(some, additive_terms({"wool"})), "the value of observation 8 is no finite number");
  some = {};
  CHECK_THROWS_WITH(anova(some, {}), "there are no observations");
  Observations constant{"error", {1.0, 1.1}, {running("feedback", 1, 1, 2)}};
  CHECK(anova(constant, additive_terms({"feedback"})).warnings.at(0) ==
        "'feedback' cannot be estimated: it has one level only");
}

}  // namespace stepwire::statistics
