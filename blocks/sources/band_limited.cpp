#include "blocks/sources/band_limited.hpp"

#include <numbers>

#include "blocks/sources/fourier.hpp"

namespace stepwire {

namespace {

using Spectrum = std::vector<std::complex<double>>;

/// The spectrum of the signal a part of an interval later. The line at half of the sample rate, of which
/// samples tell only the cosine, stays a cosine.
Spectrum later(const Spectrum& spectrum, double part) {
  Spectrum result = spectrum;
  const std::size_t n = spectrum.size();
  for (std::size_t k = 1; k < n; ++k) {
    const double line = 2 * k < n ? static_cast<double>(k) : -static_cast<double>(n - k);
    const double angle = 2.0 * std::numbers::pi * line * part / static_cast<double>(n);
    result[k] *= 2 * k == n ? std::complex<double>(std::cos(angle)) : std::polar(1.0, angle);
  }
  return result;
}

}  // namespace

BandLimited::BandLimited(const Eigen::ArrayXd& samples)
    : length_(static_cast<double>(samples.size() * refinement)), fine_(samples.size() * refinement + points) {
  const Eigen::Index length = samples.size() * refinement;
  Eigen::ArrayXd fine(length);
  const Spectrum spectrum = fourier(Spectrum(samples.begin(), samples.end()));
  for (Eigen::Index part = 0; part < refinement; ++part) {
    const Spectrum shifted =
        inverse_fourier(later(spectrum, static_cast<double>(part) / static_cast<double>(refinement)));
    for (Eigen::Index n = 0; n < samples.size(); ++n)
      fine[n * refinement + part] = part == 0 ? samples[n] : shifted[static_cast<std::size_t>(n)].real();
  }
  for (Eigen::Index k = 0; k < fine_.size(); ++k) fine_[k] = fine[((k - before) % length + length) % length];
}

}  // namespace stepwire
