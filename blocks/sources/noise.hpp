#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/base/math/normal_quantile.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// White noise, one independent sample per tick and element: y = mean + deviation w, w of mean 0 and
/// variance 1.
struct Noise {
  enum class Distribution { normal, uniform };

  std::int64_t seed = 0;
  Distribution distribution = Distribution::normal;
  PerElement mean = 0.0, deviation = 1.0, power = 0.0;
  Output<> y{};
  DiscreteState<1> sample{};
  Period period{};
  PerElement spread = 0.0;  ///< standard deviation of a sample

  void prepare() {
    spread = PerElement::made(std::max(power.size(), deviation.size()), [this](Index k) {
      return power[k] > 0.0 ? std::sqrt(power[k] / period) : deviation[k];
    });
  }
  void outputs() {
    for (Index k = 0; k < y.size(); ++k) y[k] = mean[k] + spread[k] * standard(k);
  }
  void update() { sample = sample + 1.0; }

  /// Returns a sample that depends only on the seed, the element and the number of the sample, so that a run
  /// can be resumed from any instant.
  double standard(Index element) const {
    const double even = even_sample(seed, element, sample);
    constexpr double width = 3.4641016151377545871;  // sqrt(12), which gives variance 1
    return distribution == Distribution::uniform ? width * (even - 0.5) : normal_quantile(even);
  }

  void configure(Configure& is);
  static void declare(Declare<Noise>& is);
};

}  // namespace stepwire
