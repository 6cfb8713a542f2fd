#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"
#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

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

}  // namespace stepwire::statistics
