#include "engine/analyse/linear/frequency_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stepwire::linear {

FrequencyResponse::FrequencyResponse(const StateSpace& system)
    : response_(system), sample_time_(system.sample_time), corners_(modes_of(system)) {
  for (const Complex& zero : zeros_of(system)) {
    const Complex s = system.is_sampled() ? std::log(zero) / system.sample_time : zero;
    corners_.push_back({zero, std::abs(s), std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0});
  }
  for (const InnerDelay& delay : system.delays) delay_ += delay.time;
}

Complex FrequencyResponse::at(double frequency) const {
  return response_.at(sample_time_ > 0.0 ? std::polar(1.0, frequency * sample_time_)
                                         : Complex(0.0, frequency));
}

double FrequencyResponse::last_followed() const {
  return delay_ > 0.0 ? 500.0 / delay_ : std::numeric_limits<double>::infinity();
}

std::array<double, 2> FrequencyResponse::range() const {
  const double half = sample_time_ > 0.0 ? std::numbers::pi / sample_time_ : 0.0;
  double low = half > 0.0 ? half : 1e300, high = 0.0;
  for (const Mode& corner : corners_) {
    if (!std::isfinite(corner.frequency) || corner.frequency < 1e-9 * (1.0 + half)) continue;
    low = std::min(low, corner.frequency);
    high = std::max(high, corner.frequency);
  }
  if (high == 0.0) low = high = half > 0.0 ? half : 1.0;
  const double first = std::pow(10.0, std::floor(std::log10(low)) - 2.0);
  if (half > 0.0) return {first, half};
  constexpr double turns = 12.0;  // phase of all delays together that is shown [rad]
  if (delay_ > 0.0) return {first, std::min(last_followed(), std::max(10.0 * high, turns / delay_))};
  return {first, std::pow(10.0, std::ceil(std::log10(high)) + 2.0)};
}

/// True if the gain may still cross 1 beyond a frequency. Beyond all corners the gain is a power of the
/// frequency and the phase is constant. Until then, or while the gain is near 1 or approaches it over the
/// next decade, the search must continue.
bool FrequencyResponse::may_cross_beyond(double frequency, double decade) const {
  constexpr double bend = 0.02, clear = 2.3;  // [rad], of a logarithm
  const Complex here = at(frequency), there = at(frequency * decade);
  const double gain = std::log(std::abs(here)), change = std::log(std::abs(there)) - gain;
  if (!std::isfinite(gain) || !std::isfinite(change)) return false;
  if (decade < 1.0 && std::abs(std::arg(there / here)) > bend) return true;
  if (std::abs(change) < 1e-3) return false;
  return std::abs(gain) < clear || gain * change < 0.0;
}

/// Adds frequencies at which the phase of all delays together advances by 0.1 rad.
void FrequencyResponse::add_turns(double first, double last, std::vector<double>& frequencies) const {
  if (delay_ == 0.0) return;
  const double step = 0.1 / delay_;
  for (double w = first + step; w < std::min(last, last_followed()); w += step) frequencies.push_back(w);
}

std::vector<double> FrequencyResponse::frequencies_across_one(std::size_t per_decade) const {
  constexpr int decades = 100;
  std::vector<double> all = frequencies(per_decade);
  const double lowest = all.front(), highest = all.back();
  const auto extend = [&](double from, double decade) {
    for (int k = 0; k < decades && may_cross_beyond(from, decade); ++k, from *= decade)
      for (std::size_t i = 1; i <= per_decade; ++i)
        all.push_back(from * std::pow(decade, static_cast<double>(i) / static_cast<double>(per_decade)));
  };
  extend(lowest, 0.1);
  if (sample_time_ == 0.0) extend(highest, 10.0);
  add_turns(highest, all.back(), all);
  std::ranges::sort(all);
  return all;
}

/// Extrapolates to rest: near it the gain is constant, or grows with the order of the pole.
double FrequencyResponse::at_rest() const {
  const auto near = [&](double s) {
    return response_.at(sample_time_ > 0.0 ? std::exp(s * sample_time_) : s).real();
  };
  double lowest = sample_time_ > 0.0 ? 1.0 / sample_time_ : 1.0;
  for (const Mode& corner : corners_)
    if (corner.frequency > 0.0) lowest = std::min(lowest, corner.frequency);
  const double far = near(1e-5 * lowest), closer = near(1e-7 * lowest);
  if (std::abs(closer) > 30.0 * std::abs(far))
    return std::copysign(std::numeric_limits<double>::infinity(), closer);
  return response_.at(sample_time_ > 0.0 ? 1.0 : 0.0).real();
}

std::vector<double> FrequencyResponse::frequencies(std::size_t per_decade) const {
  const auto [first, last] = range();
  const double decades = std::log10(last / first);
  const auto count = static_cast<int>(std::max(1.0, decades * static_cast<double>(per_decade)));
  std::vector<double> all{last};
  for (int k = 0; k < count; ++k) all.push_back(first * std::pow(10.0, decades * k / count));
  for (const Mode& corner : corners_)
    for (int k = -20; k <= 20; ++k)
      all.push_back(corner.frequency * (1.0 + 0.25 * k * std::min(0.1, std::abs(corner.damping))));
  add_turns(0.0, last, all);
  std::erase_if(all, [first = first, last = last](double w) { return !(w >= first && w <= last); });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace stepwire::linear
