#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"
#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Cohen's d of two conditions within subjects. What does not exist is nan.
struct PairedEffect {
  double d_z = 0.0;  ///< mean difference over the standard deviation of the differences (Cohen 1988)
  ConfidenceInterval interval;  ///< of d_z, 95 %, by the noncentral t
  double d_av = 0.0;            ///< mean difference over the mean of both standard deviations (Lakens 2013)
};

/// First minus second; one value of each subject in both.
PairedEffect paired_effect(const std::vector<double>& first, const std::vector<double>& second);

/// Shares of the variance that a term of repeated measures explains. What does not exist is nan.
struct TermEffect {
  std::string term;
  double partial = 0.0;  ///< partial eta squared
  ConfidenceInterval
      interval;              ///< of it, 90 %, by the noncentral F (Smithson 2003): lambda / (lambda + df + 1)
  double generalised = 0.0;  ///< over the term and all that varies between subjects (Olejnik and Algina 2003)
};

/// Of every term that has an F; all factors are manipulated within subjects.
std::vector<TermEffect> term_effects(const Anova& repeated);

}  // namespace stepwire::statistics
