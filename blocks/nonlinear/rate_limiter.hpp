#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Follows its input, but no faster than its rates allow.
struct RateLimiter {
  PerElement rising = 1.0, falling = -1.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};
  DiscreteState<1> elapsed{};  // since the last tick: none at the first one
  Period period{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = reached(i);
  }

  void update() {
    for (Eigen::Index i = 0; i < last.size(); ++i) last.coeffRef(i) = reached(i);
    elapsed = period;
  }

  static void declare(Declare<RateLimiter>& is);

 private:
  double reached(Eigen::Index i) const {
    const double from = last.coeff(i);
    return std::clamp(u.coeff(i), from + falling.coeff(i) * elapsed, from + rising.coeff(i) * elapsed);
  }
};

}  // namespace stepwire
