#pragma once

#include <vector>

namespace stepwire {

/// Second-order section: y_n = b0 u_n + b1 u_(n-1) + b2 u_(n-2) - a1 y_(n-1) - a2 y_(n-2).
struct FilterSection {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

/// Butterworth low-pass of an order from 1 on, by the bilinear transform with its frequency prewarped: gain 1
/// at rest and 1/sqrt(2) at `cutoff`, which is a share of the sample rate between 0 and 1/2. One section for
/// two orders, an odd one last.
std::vector<FilterSection> butterworth(int order, double cutoff);

/// The sections run forward and backward over the rows, as sosfiltfilt of scipy.signal does by default: the
/// rows go on at either end, turned about the end, for 3 (order + 1) rows, and each pass begins in the steady
/// state of its first row. There must be more rows than that. F. Gustafsson, IEEE Trans. Signal Process. 44
/// (1996) 988 treats such ends.
std::vector<double> forward_and_backward(const std::vector<FilterSection>& sections, int order,
                                         const std::vector<double>& rows);

/// By how many rows they go on at either end.
int rows_beyond_ends(int order);

}  // namespace stepwire
