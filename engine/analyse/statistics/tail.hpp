#pragma once

namespace stepwire::statistics {

/// Probability that Fisher's F with so many degrees of freedom (above 0, fractions allowed) is `value` or
/// more; 0 for an infinite value, nan for nan.
double fisher_tail(double value, double above, double below);

/// The value that Fisher's F reaches or exceeds with a probability (0 to 1, both exclusive).
double fisher_critical(double probability, double above, double below);

/// Probability that chi-squared is `value` or more, as fisher_tail.
double chi_squared_tail(double value, double freedom);

}  // namespace stepwire::statistics
