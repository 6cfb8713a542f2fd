#pragma once

namespace stepwire {

/// Probability that Fisher's F with so many degrees of freedom (above 0, fractions allowed) is `value` or
/// more; 0 for an infinite value, nan for nan.
double fisher_tail(double value, double above, double below);

/// The same of the chi-squared distribution.
double chi_squared_tail(double value, double freedom);

}  // namespace stepwire
