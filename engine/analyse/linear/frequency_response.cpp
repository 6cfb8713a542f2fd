#include "engine/analyse/linear/frequency_response.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace stepwire::linear {
namespace {

constexpr std::size_t rows_per_decade = 200;

Mode corner_of_zero(const Complex& zero, double sample_time) {
  const Complex s = sample_time > 0.0 ? std::log(zero) / sample_time : zero;
  return {zero, std::abs(s), std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0};
}

}  // namespace

double find_zero(const std::function<double(double)>& function, double low, double high) {
  const bool rises = function(low) < 0.0;
  for (int k = 0; k < 200 && high - low > 4e-16 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (((function(middle) < 0.0) == rises) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

CurvePoint find_minimum(const std::function<double(double)>& function, double low, double high) {
  // Shares of the interval: the accuracy of the method is absolute below 1.
  const auto at = [&](double share) { return low + share * (high - low); };
  const auto [share, least] = boost::math::tools::brent_find_minima(
      [&](double s) { return function(at(s)); }, 0.0, 1.0, std::numeric_limits<double>::digits / 2);
  return {at(share), least};
}

FrequencyResponse::FrequencyResponse(const StateSpace& system)
    : chain_(delay_chain(system)),
      response_(chain_ ? chain_->rational : system),
      sample_time_(system.sample_time),
      direct_(chain_ ? chain_->rational.D(0, 0) : largest_gain(system.D)),
      corners_(modes_of(chain_ ? chain_->rational : system)) {
  const std::vector<Complex> zeros = zeros_of(chain_ ? chain_->rational : system);
  for (const Complex& zero : zeros) corners_.push_back(corner_of_zero(zero, sample_time_));
  samples_ =
      sample_time_ > 0.0 ? static_cast<double>(system.A.rows()) - static_cast<double>(zeros.size()) : 0.0;
  for (const InnerDelay& delay : system.delays) delay_ += delay.time;
}

/// Returns the response; without the delays for a chain.
Complex FrequencyResponse::plain(double frequency) const {
  return response_.at(sample_time_ > 0.0 ? std::polar(1.0, frequency * sample_time_)
                                         : Complex(0.0, frequency));
}

Complex FrequencyResponse::at(double frequency) const {
  const bool turns = chain_ && delay_ > 0.0 && std::isfinite(frequency);
  return turns ? plain(frequency) * std::polar(1.0, -frequency * delay_) : plain(frequency);
}

double FrequencyResponse::bound(double frequency) const {
  return response_.bound(Complex(0.0, frequency));
}

double FrequencyResponse::last_followed() const {
  return delay_ > 0.0 ? 500.0 / delay_ : std::numeric_limits<double>::infinity();
}

/// Returns the lowest and the highest frequency of the corners, except 0 and infinity; 1 without one.
std::array<double, 2> FrequencyResponse::ends_of(const std::vector<Mode>& corners) const {
  const double half = sample_time_ > 0.0 ? std::numbers::pi / sample_time_ : 0.0;
  double low = half > 0.0 ? half : 1e300, high = 0.0;
  for (const Mode& corner : corners) {
    if (!std::isfinite(corner.frequency) || corner.frequency < 1e-9 * (1.0 + half)) continue;
    low = std::min(low, corner.frequency);
    high = std::max(high, corner.frequency);
  }
  if (high == 0.0) low = high = half > 0.0 ? half : 1.0;
  return {std::min(low, last_followed()), half > 0.0 ? half : high};
}

/// Returns the range from two decades below the corners to two decades above, without regard to delays.
std::array<double, 2> FrequencyResponse::plain_range(const std::vector<Mode>& corners) const {
  const auto [low, high] = ends_of(corners);
  return {std::pow(10.0, std::floor(std::log10(low)) - 2.0),
          is_sampled() ? high : std::pow(10.0, std::ceil(std::log10(high)) + 2.0)};
}

std::array<double, 2> FrequencyResponse::range() const {
  const auto [first, last] = plain_range(corners_);
  if (delay_ == 0.0) return {first, last};
  constexpr double turns = 12.0;  // phase of all delays together that is shown [rad]
  return {first, std::min(last_followed(), std::max(10.0 * ends_of(corners_)[1], turns / delay_))};
}

/// True if the gain may still cross 1 beyond a frequency. Beyond all corners the gain is a power of the
/// frequency and the phase is constant. Until then, or while the gain is near 1 or approaches it over the
/// next decade, the search must continue.
bool FrequencyResponse::may_cross_beyond(double frequency, double decade) const {
  constexpr double bend = 0.02, clear = 2.3;  // [rad], of a logarithm
  const Complex here = plain(frequency), there = plain(frequency * decade);
  const double gain = std::log(std::abs(here)), change = std::log(std::abs(there)) - gain;
  if (!std::isfinite(gain) || !std::isfinite(change)) return false;
  if (decade < 1.0 && std::abs(std::arg(there / here)) > bend) return true;
  if (std::abs(change) < 1e-3) return false;
  return std::abs(gain) < clear || gain * change < 0.0;
}

/// Adds frequencies at which the phase of all delays together advances by 0.1 rad.
void FrequencyResponse::add_turns(double first, double last, std::vector<double>& frequencies) const {
  constexpr double few_samples = 8.0;
  const double together = samples_ < few_samples ? delay_ : samples_ * sample_time_;
  if (together == 0.0) return;
  const double step = 0.1 / together;
  for (double w = first + step; w < std::min(last, last_followed()); w += step) frequencies.push_back(w);
}

/// Adds decades at one end while the gain may cross 1 there.
void FrequencyResponse::extend(double from, double decade, std::vector<double>& frequencies) const {
  constexpr int decades = 100;
  for (int k = 0; k < decades && may_cross_beyond(from, decade); ++k, from *= decade)
    for (std::size_t i = 1; i <= rows_per_decade; ++i)
      frequencies.push_back(from *
                            std::pow(decade, static_cast<double>(i) / static_cast<double>(rows_per_decade)));
}

/// Adds two turns of the delays about each point where the gain of a chain is 1 or nearest to 1. Elsewhere
/// beyond last_followed() the gain changes little during a turn, so crossings are farther from -1 there.
void FrequencyResponse::add_windows(std::vector<double>& frequencies) const {
  constexpr int rows = 130;  // on each side, of 0.1 rad
  const auto gain = [&](double w) { return std::log(std::abs(plain(w))); };
  const auto off = [&](double w) { return std::abs(gain(w)); };
  std::vector<double> centres;
  for (std::size_t k = 1; k + 1 < frequencies.size(); ++k) {
    if (frequencies[k] < last_followed()) continue;
    const double w = frequencies[k], before = frequencies[k - 1], after = frequencies[k + 1];
    if ((gain(before) < 0.0) != (gain(w) < 0.0)) centres.push_back(find_zero(gain, before, w));
    if (off(w) <= off(before) && off(w) <= off(after)) centres.push_back(find_minimum(off, before, after).x);
  }
  if (centres.size() > 100) return;  // noise about a gain of 1
  for (const double centre : centres)
    for (int k = -rows; k <= rows; ++k) frequencies.push_back(centre + 0.1 * k / delay_);
}

std::vector<double> FrequencyResponse::search_frequencies(const std::vector<Mode>& closed) const {
  constexpr std::size_t most_closed = 40;
  std::vector<Mode> corners = closed;
  std::ranges::sort(corners, {}, [](const Mode& mode) { return std::abs(mode.damping); });
  corners.resize(std::min(corners.size(), most_closed));  // the others do not resonate
  corners.insert(corners.end(), corners_.begin(), corners_.end());
  const auto [first, last] = plain_range(corners);
  std::vector<double> all = spread(first, last, rows_per_decade, corners);
  extend(first, 0.1, all);
  if (sample_time_ == 0.0) extend(last, 10.0, all);
  std::ranges::sort(all);
  const double highest = all.back();
  if (chain_ && delay_ > 0.0) add_windows(all);
  add_turns(0.0, highest, all);
  std::erase_if(all, [](double w) { return !(w > 0.0); });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Returns frequencies at equal ratios, and denser ones near corners.
std::vector<double> FrequencyResponse::spread(double first, double last, std::size_t per_decade,
                                              const std::vector<Mode>& corners) const {
  const double decades = std::log10(last / first);
  const auto count = static_cast<int>(std::max(1.0, decades * static_cast<double>(per_decade)));
  std::vector<double> all{last};
  for (int k = 0; k < count; ++k) all.push_back(first * std::pow(10.0, decades * k / count));
  const auto add = [&](const Mode& corner) {
    for (int k = -20; k <= 20; ++k)
      all.push_back(corner.frequency * (1.0 + 0.25 * k * std::min(0.1, std::abs(corner.damping))));
  };
  std::ranges::for_each(corners, add);
  std::erase_if(all, [&](double w) { return !(w >= first && w <= last); });
  return all;
}

std::vector<double> FrequencyResponse::frequencies(std::size_t per_decade) const {
  const auto [first, last] = range();
  std::vector<double> all = spread(first, last, per_decade, corners_);
  add_turns(0.0, last, all);
  std::erase_if(all, [first = first](double w) { return w < first; });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace stepwire::linear
