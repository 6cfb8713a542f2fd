#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// What the resistance F to a motion tells of the side on which one has left a corridor. F stands out from
/// the resistance E of a free motion where F > E + just (weber E + threshold). With the way r that was felt
/// outward since then, the logarithm of the odds of the outer side, l, is
///
///     on leaving:  l = 1.702 rate/wrong (the normal distribution of a rate of error `wrong`),
///     then:        l <- l + ((F - W(-r))^2 - (F - W(r))^2)/(2 (weber F)^2 + 2 (slope wrong t)^2),
///
/// where W(r) = offset + slope max(0, r) is what the wall would resist by then, a time t after. With
/// side = tanh(l/2) and d = (F - offset)/slope the hand is at side (half + d), with the variance of the other
/// side and of the felt force.
struct WallSense {
  double weber = 0.1, threshold = 0.0, just = 3.0, wrong = 1.0;
  double offset = 0.0, slope = 1.0, half = 0.0;
  Input<1> resistance{}, free{}, rate{};
  Output<1> outside{}, side{}, measured{}, precision{};
  DiscreteState<1> odds{}, way{}, since{};  ///< l, r and t at the last tick; t is 0 inside
  Period period;

  void outputs() {
    outside = resistance > free + just * (weber * free + threshold) ? 1.0 : 0.0;
    side = outside != 0.0 ? std::tanh(0.5 * now()) : 0.0;
    const double far = half + std::max(0.0, (resistance - offset) / slope), blur = error() / slope;
    measured = side * far;
    precision = outside != 0.0 ? 1.0 / ((1.0 - side * side) * far * far + blur * blur) : 0.0;
  }

  void update() {
    const bool is = outside != 0.0;
    odds = is ? now() : 0.0;
    way = is && since > 0.0 ? moved() : 0.0;
    since = is ? since + period : 0.0;
  }

  static void declare(Declare<WallSense>& is);

 private:
  double error() const { return std::hypot(weber * resistance, threshold); }
  double moved() const { return way + rate * period; }
  double wall(double out) const { return offset + slope * std::max(0.0, out); }

  double now() const {
    constexpr double logistic = 1.702, most = 8.0;
    if (since == 0.0) return std::clamp(logistic * rate / wrong, -most, most);
    const double outer = resistance - wall(moved()), inner = resistance - wall(-moved());
    const double doubt = slope * wrong * since, square = error() * error() + doubt * doubt;
    return std::clamp(odds + (inner * inner - outer * outer) / (2.0 * square), -most, most);
  }
};

}  // namespace stepwire
