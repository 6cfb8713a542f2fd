#pragma once

#include <vector>

namespace stepwire {

/// Second-order section: y_n = b0 u_n + b1 u_(n-1) + b2 u_(n-2) - a1 y_(n-1) - a2 y_(n-2).
struct FilterSection {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

/// Returns a Butterworth low-pass of an order from 1 on, by the bilinear transform with prewarped frequency.
/// Its gain is 1 at rest and 1/sqrt(2) at `cutoff`, which is a fraction of the sample rate between 0 and 1/2.
/// Each section has two orders; an odd one is last.
std::vector<FilterSection> butterworth(int order, double cutoff);

/// Filters the rows forward and backward, like sosfiltfilt of scipy.signal with its defaults. The rows are
/// extended at either end by 3 (order + 1) point-reflected rows, and there must be more rows than that. Each
/// pass begins in the steady state of its first row. For such ends see F. Gustafsson, IEEE Trans. Signal
/// Process. 44 (1996) 988.
std::vector<double> forward_and_backward(const std::vector<FilterSection>& sections, int order,
                                         const std::vector<double>& rows);

/// Returns the number of rows of the extension at either end.
int rows_beyond_ends(int order);

}  // namespace stepwire
