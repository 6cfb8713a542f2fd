#pragma once

#include <complex>
#include <vector>

namespace stepwire {

/// Returns the discrete Fourier transform, X_k = sum_n x_n exp(-2 pi i k n / N), for any N in O(N log N).
std::vector<std::complex<double>> fourier(const std::vector<std::complex<double>>& x);

/// Returns its inverse, x_n = 1/N sum_k X_k exp(2 pi i k n / N).
std::vector<std::complex<double>> inverse_fourier(const std::vector<std::complex<double>>& spectrum);

}  // namespace stepwire
