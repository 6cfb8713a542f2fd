#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Limits of a confidence interval; nan if undefined.
struct ConfidenceInterval {
  double low = 0.0, high = 0.0;
};

/// Student's t test of the differences between two conditions, one difference per subject. Undefined values
/// are nan: all but the mean for fewer than two differences, t and P for equal ones.
struct PairedTest {
  double mean = 0.0;            ///< Mean of the differences.
  double deviation = 0.0;       ///< Standard deviation of the differences.
  double freedom = 0.0;         ///< Number of differences less one.
  double t = 0.0, p = 0.0;      ///< P is two-sided.
  ConfidenceInterval interval;  ///< 95 % interval of the mean.
};

PairedTest paired_test(const std::vector<double>& differences);

/// Returns the interval of a mean: `mean` -/+ t(0.975, freedom) times its standard error; nan without degrees
/// of freedom.
ConfidenceInterval student_interval(double mean, double standard_error, double freedom);

/// Cohen's d of two within-subject conditions. Missing values are nan.
struct PairedEffect {
  double d_z = 0.0;  ///< Mean difference over the standard deviation of the differences (Cohen 1988).
  ConfidenceInterval interval;  ///< 95 % interval of d_z, by the noncentral t.
  double d_av = 0.0;            ///< Mean difference over the mean of both standard deviations (Lakens 2013).
};

/// Computes the effect of the first minus the second condition; each subject has one value in both.
PairedEffect paired_effect(const std::vector<double>& first, const std::vector<double>& second);

/// Shares of variance explained by a term of repeated measures. Missing values are nan.
struct TermEffect {
  std::string term;
  double partial = 0.0;  ///< Partial eta squared.
  ConfidenceInterval
      interval;  ///< 90 % interval of it, by the noncentral F (Smithson 2003): lambda / (lambda + df + 1).
  double generalised =
      0.0;  ///< Share of the term and of all variance between subjects (Olejnik and Algina 2003).
};

/// Computes the effects of every term with an F; all factors are manipulated within subjects.
std::vector<TermEffect> term_effects(const Anova& repeated);

/// Wilcoxon's signed-rank test of differences between two conditions. Zero differences are left out; equal
/// ones share the mean of their ranks.
struct SignedRank {
  double sum = 0.0;       ///< V, the sum of the ranks of positive differences.
  double p = 1.0;         ///< Two-sided P; nan if all differences are zero.
  bool exact = true;      ///< True: P is exact, over all signs of these ranks including ties; false: by the
                          ///< normal distribution.
  std::size_t count = 0;  ///< Number of differences other than zero.
};

/// Computes the test: exact up to `largest_exact` differences, else normal with continuity correction.
SignedRank signed_rank_test(const std::vector<double>& differences, std::size_t largest_exact = 50);

/// Returns probabilities corrected for their number m, in the given order (Holm 1979). The i-th smallest is
/// multiplied by m - i + 1; the results are made monotonic and limited to 1. Nan remains nan and is not
/// counted.
std::vector<double> holm_corrected(const std::vector<double>& probabilities);

}  // namespace stepwire::statistics
