#pragma once

#include <vector>

namespace stepwire::statistics {

/// Probabilities corrected for their number after Holm 1979 (the i-th smallest of m times m - i + 1, never
/// below the one before, at most 1), in the order given. Nan stays nan and does not count.
std::vector<double> holm_corrected(const std::vector<double>& probabilities);

}  // namespace stepwire::statistics
