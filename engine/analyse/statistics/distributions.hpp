#pragma once

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Returns the quantile of Student's t; 0 < probability < 1, `freedom` above 0.
double student_quantile(double probability, double freedom);

/// Returns the probability that the noncentral t exceeds `value`; `freedom` is above 0.
double noncentral_student_tail(double value, double freedom, double noncentrality);

/// Returns the noncentralities at which t is the 0.975 and the 0.025 quantile (Steiger and Fouladi 1997). Nan
/// for a t of 10000 or more, and for nan.
ConfidenceInterval noncentrality_of_t(double t, double freedom);

/// Returns the 90 % interval of the noncentrality of F. Nan if F times its numerator degrees of freedom is
/// 1e8 or more. A negative end is set to 0.
ConfidenceInterval noncentrality_of_f(double f, double above, double below);

/// Returns the probability that Fisher's F is `value` or more. Degrees of freedom are above 0 and may be
/// fractions. 0 for an infinite value, nan for nan.
double fisher_tail(double value, double above, double below);

/// Returns the value that Fisher's F reaches with a probability between 0 and 1, both exclusive.
double fisher_critical(double probability, double above, double below);

/// Returns the probability that chi-squared is `value` or more, with the conventions of fisher_tail.
double chi_squared_tail(double value, double freedom);

/// Returns the quantile of the beta distribution; 0 < probability < 1, both shapes above 0.
double beta_quantile(double probability, double a, double b);

/// Returns the probability that a beta variable is `value` or more; 0 <= value <= 1.
double beta_tail(double value, double a, double b);

}  // namespace stepwire::statistics
