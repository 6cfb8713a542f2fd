#pragma once

#include <cmath>
#include <cstdint>

#include "engine/base/math/normal_quantile.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Ornstein-Uhlenbeck process over a coordinate s: Gaussian, of mean 0 and of the covariance
/// deviation^2 exp(-|s - s'| / correlation). From tick to tick, exactly,
///
///     y <- r y + deviation sqrt(1 - r^2) w,   r = exp(-|change of s| / correlation),  w normal.
struct OrnsteinUhlenbeck {
  std::int64_t seed = 0;
  PerElement deviation = 1.0;
  double correlation = 1.0;
  Input<1> along{};
  Output<> y{};
  DiscreteState<> value{};
  DiscreteState<1> last{}, sample{};  ///< s at the tick before; number of the sample

  void outputs() { y = value; }

  void update() {
    const double ago = sample > 0.0 ? std::abs(along - last) / correlation : 0.0;
    const double kept = std::exp(-ago), fresh = std::sqrt(-std::expm1(-2.0 * ago));
    sample = sample + 1.0;
    value.each([&](Index i) { return kept * value[i] + fresh * deviation[i] * normal(i); });
    last = along;
  }

  /// It has always been going on.
  void start() {
    value.each([&](Index i) { return deviation[i] * normal(i); });
  }

  void configure(Configure& is);
  static void declare(Declare<OrnsteinUhlenbeck>& is);

 private:
  double normal(Index element) const { return normal_quantile(even_sample(seed, element, sample)); }
};

}  // namespace stepwire
