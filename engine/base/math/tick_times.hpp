#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace stepwire {

/// Times of the ticks of a step. The step is a fraction: tick k is at k * numerator / denominator [s],
/// rounded once. So a tick has the same number as its decimal in a file. Tick 3 of a step of 0.3 s is 0.9 s;
/// the product 3 * 0.3 is below it.
struct TickTimes {
  double numerator = 0.0, denominator = 1.0;

  double operator()(std::int64_t tick) const { return (*this)(static_cast<double>(tick)); }
  double operator()(double ticks) const { return ticks * numerator / denominator; }
};

/// Returns the fraction that a step [s] is within rounding: a decimal of at most 15 digits, or 1 over a whole
/// number. Any other step is its own numerator over 1.
inline TickTimes tick_times(double step) {
  const auto is_step = [step](double value) {
    return std::abs(value - step) <= std::numeric_limits<double>::epsilon() * step;
  };
  double power = 1.0;  // exact up to 1e22
  for (int digits = 0; digits <= 22; ++digits, power *= 10.0) {
    const double whole = std::round(step * power);
    if (!(whole < 1e15)) break;
    if (is_step(whole / power)) return {whole, power};
  }
  const double parts = std::round(1.0 / step);
  if (is_step(1.0 / parts)) return {1.0, parts};
  return {step, 1.0};
}

}  // namespace stepwire
