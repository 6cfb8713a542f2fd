#pragma once

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Returns the probability that the noncentral t exceeds `value`; `freedom` is above 0.
double noncentral_student_tail(double value, double freedom, double noncentrality);

/// Returns the noncentralities at which t is the 0.975 and the 0.025 quantile (Steiger and Fouladi 1997). Nan
/// for a t of 10000 or more, and for nan.
ConfidenceInterval noncentrality_of_t(double t, double freedom);

/// Returns the 90 % interval of the noncentrality of F. Nan if F times its numerator degrees of freedom is
/// 1e8 or more. A negative end is set to 0.
ConfidenceInterval noncentrality_of_f(double f, double above, double below);

}  // namespace stepwire::statistics
