#pragma once

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Probability that the noncentral t is above `value`. `freedom` above 0.
double noncentral_student_tail(double value, double freedom, double noncentrality);

/// The noncentralities for which a t as large, and one as small, as this one has the probability 0.025
/// (Steiger and Fouladi 1997). Nan for a t of 10000 or more, and for nan.
ConfidenceInterval noncentrality_of_t(double t, double freedom);

/// The same of F (its root as large as that t at most) with the probability 0.05 each; an end that would lie
/// below 0 is 0.
ConfidenceInterval noncentrality_of_f(double f, double above, double below);

}  // namespace stepwire::statistics
