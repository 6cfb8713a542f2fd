#include "blocks/records/band_limited.hpp"

#include <numbers>

#include "blocks/records/fourier.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

using Spectrum = std::vector<std::complex<double>>;

/// Returns the spectrum of the signal, shifted by a part of an interval. The line at half the sample rate
/// stays a cosine, since samples determine only its cosine.
Spectrum later(const Spectrum& spectrum, double part) {
  Spectrum result = spectrum;
  const std::size_t n = spectrum.size();
  for (std::size_t k = 1; k < n; ++k) {
    const double line = 2 * k < n ? static_cast<double>(k) : -static_cast<double>(n - k);
    const double angle = 2.0 * std::numbers::pi * line * part / static_cast<double>(n);
    result[k] *= 2 * k == n ? std::complex<double>(fn::cos(angle))
                            : std::complex<double>(fn::cos(angle), fn::sin(angle));
  }
  return result;
}

/// Returns the samples with `times` - 1 more between any two.
std::vector<double> refined(const std::vector<double>& samples, std::size_t times) {
  std::vector<double> fine(samples.size() * times);
  const Spectrum spectrum = fourier(Spectrum(samples.begin(), samples.end()));
  for (std::size_t part = 0; part < times; ++part) {
    const Spectrum shifted =
        inverse_fourier(later(spectrum, static_cast<double>(part) / static_cast<double>(times)));
    for (std::size_t n = 0; n < samples.size(); ++n)
      fine[n * times + part] = part == 0 ? samples[n] : shifted[n].real();
  }
  return fine;
}

}  // namespace

BandLimited BandLimited::through(const Matrix& samples) {
  const Index period = samples.columns() * refinement, rows = period + points;
  std::vector<double> all;
  for (Index signal = 0; signal < samples.rows(); ++signal) {
    std::vector<double> given;
    for (Index n = 0; n < samples.columns(); ++n) given.push_back(samples(signal, n));
    const std::vector<double> one = refined(given, refinement);
    for (Index k = 0; k < rows; ++k)
      all.push_back(one[static_cast<std::size_t>(((k - before) % period + period) % period)]);
  }
  return {static_cast<double>(period), Matrix(rows, samples.rows(), Numbers(all))};
}

}  // namespace stepwire
