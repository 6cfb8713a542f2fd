#pragma once

#include <vector>

namespace stepwire::statistics {

/// Returns probabilities corrected for their number m, in the given order (Holm 1979). The i-th smallest is
/// multiplied by m - i + 1; the results are made monotonic and limited to 1. Nan remains nan and is not
/// counted.
std::vector<double> holm_corrected(const std::vector<double>& probabilities);

}  // namespace stepwire::statistics
