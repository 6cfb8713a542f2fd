#include "blocks/records/fourier.hpp"

#include <bit>
#include <numbers>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

using Complex = std::complex<double>;
using Series = std::vector<Complex>;

/// Returns exp(-2 pi i turns / of).
Complex unit_root(std::size_t turns, std::size_t of) {
  const double angle = -2.0 * std::numbers::pi * static_cast<double>(turns) / static_cast<double>(of);
  return {fn::cos(angle), fn::sin(angle)};
}

/// Permutes the elements by reversing the bits of their index.
Series bit_reversed(const Series& x) {
  Series result(x.size());
  for (std::size_t n = 0, reverse = 0; n < x.size(); ++n) {
    result[reverse] = x[n];
    std::size_t bit = x.size() >> 1;
    for (; bit && (reverse & bit); bit >>= 1) reverse ^= bit;
    reverse |= bit;
  }
  return result;
}

/// Transforms a power of two by the algorithm of Cooley and Tukey.
Series power_of_two(const Series& x) {
  Series result = bit_reversed(x), roots(x.size() / 2);
  for (std::size_t k = 0; k < roots.size(); ++k) roots[k] = unit_root(k, x.size());
  for (std::size_t half = 1; half < x.size(); half *= 2)
    for (std::size_t block = 0; block < x.size(); block += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        const Complex a = result[block + k],
                      b = result[block + k + half] * roots[k * (x.size() / (2 * half))];
        result[block + k] = a + b;
        result[block + k + half] = a - b;
      }
  return result;
}

/// Transforms any length by Bluestein's algorithm: k n = (k^2 + n^2 - (k - n)^2) / 2 converts a transform
/// into a convolution, which is three transforms of a power of two.
Series any_length(const Series& x) {
  const std::size_t n = x.size(), padded = std::bit_ceil(2 * n);
  Series chirp(n), signal(padded), kernel(padded);
  for (std::size_t k = 0; k < n; ++k) {
    chirp[k] = unit_root(k * k % (2 * n), 2 * n);
    signal[k] = x[k] * chirp[k];
    kernel[k] = kernel[(padded - k) % padded] = std::conj(chirp[k]);
  }
  Series product = power_of_two(signal);
  const Series factor = power_of_two(kernel);
  for (std::size_t k = 0; k < padded; ++k) product[k] = std::conj(product[k] * factor[k]);
  product = power_of_two(product);
  Series result(n);
  for (std::size_t k = 0; k < n; ++k)
    result[k] = std::conj(product[k]) / static_cast<double>(padded) * chirp[k];
  return result;
}

}  // namespace

Series fourier(const Series& x) {
  if (x.size() < 2) return x;
  return std::has_single_bit(x.size()) ? power_of_two(x) : any_length(x);
}

Series inverse_fourier(const Series& spectrum) {
  Series mirrored(spectrum.size());
  for (std::size_t k = 0; k < mirrored.size(); ++k) mirrored[k] = std::conj(spectrum[k]);
  mirrored = fourier(mirrored);
  for (Complex& value : mirrored) value = std::conj(value) / static_cast<double>(mirrored.size());
  return mirrored;
}

}  // namespace stepwire
