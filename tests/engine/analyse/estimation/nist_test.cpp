// Fits of the Statistical Reference Datasets of NIST against their certified values.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/analyse/estimation/fit_text.hpp"
#include "tests/engine/analyse/estimation/nist.hpp"

namespace stepwire::estimation {

namespace {

/// The fewest digits of the values, and of their classical standard errors.
struct Digits {
  double values = 11.0, errors = 11.0;
};

Digits digits_of(const NistSet& set, const FitResult& result) {
  Digits least;
  for (std::size_t k = 0; k < set.certified.size(); ++k) {
    const FittedNumber& one = found(result, "b" + std::to_string(k + 1));
    least.values = std::min(least.values, digits(one.value, set.certified[k]));
    least.errors = std::min(least.errors, digits(one.classical_error, set.errors[k]));
  }
  return least;
}

void check(const NistSet& set) {
  for (const std::size_t start : {0U, 1U}) {
    INFO(set.name << ", start " << start + 1);
    const FitResult result = fit_text(nist_diagram(set, start));
    const Digits least = digits_of(set, result);
    CHECK(result.converged);
    CHECK(least.values >= 6.0);
    if (set.name != "Lanczos1") CHECK(least.errors >= 4.0);  // whose residuals are rounding of 13 digits
    CHECK_FALSE(result.in_time);
  }
}

}  // namespace

TEST_CASE("Small reference sets of NIST are fitted to six certified digits from both starts") {
  for (const NistSet& set : small_nist_sets()) check(set);
}

TEST_CASE("All 27 nonlinear reference sets of NIST are fitted to six certified digits from both starts") {
  const std::vector<NistSet> sets = all_nist_sets();
  if (sets.empty()) WARN("skipped: no folder nist_strd below STEPWIRE_DATA");
  for (const NistSet& set : sets) check(set);
}

}  // namespace stepwire::estimation
