#pragma once

namespace stepwire::statistics {

/// Returns the probability that Fisher's F is `value` or more. Degrees of freedom are above 0 and may be
/// fractions. 0 for an infinite value, nan for nan.
double fisher_tail(double value, double above, double below);

/// Returns the value that Fisher's F reaches with a probability between 0 and 1, both exclusive.
double fisher_critical(double probability, double above, double below);

/// Returns the probability that chi-squared is `value` or more, with the conventions of fisher_tail.
double chi_squared_tail(double value, double freedom);

}  // namespace stepwire::statistics
