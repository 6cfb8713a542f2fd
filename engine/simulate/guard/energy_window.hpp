#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace stepwire::guard {

/// Energy of the last second, in bins of a millisecond.
///
/// Sums of doubles to which each value is added and from which it is subtracted later drift. So the bins
/// count whole parts of the limit, 2^40 of them, and the remainder of each value goes into the next one.
class EnergyWindow {
 public:
  /// `most` is the limit [J], above 0; without one the parts are of 1 J.
  explicit EnergyWindow(double most)
      : quantum_((std::isfinite(most) ? most : 1.0) / whole), bins_(count, 0) {}

  /// Adds an energy [J] that ends at an instant [ns]; instants do not decrease.
  void add(std::int64_t now, double energy) noexcept {
    const std::int64_t bin = now / width;
    for (std::int64_t next = std::max(bin_, bin - count) + 1; next <= bin; ++next) {
      sum_ -= bins_[place(next)];
      bins_[place(next)] = 0;
    }
    bin_ = std::max(bin_, bin);
    const double parts = std::clamp(energy / quantum_ + rest_, -largest, largest),
                 rounded = std::round(parts);
    rest_ = parts - rounded;
    std::int64_t& last = bins_[place(bin_)];
    const std::int64_t before = last;
    last = static_cast<std::int64_t>(std::clamp(static_cast<double>(before) + rounded, -largest, largest));
    sum_ += last - before;
  }
  /// Returns the energy of the last second [J].
  double energy() const noexcept { return static_cast<double>(sum_) * quantum_; }

 private:
  static constexpr std::int64_t width = 1'000'000, count = 1000;   ///< [ns]
  static constexpr double whole = 1ll << 40, largest = 1ll << 52;  ///< of a bin, so that no sum overflows

  static std::size_t place(std::int64_t bin) {
    return static_cast<std::size_t>((bin % count + count) % count);
  }

  double quantum_, rest_ = 0.0;
  std::vector<std::int64_t> bins_;
  std::int64_t bin_ = 0, sum_ = 0;
};

}  // namespace stepwire::guard
