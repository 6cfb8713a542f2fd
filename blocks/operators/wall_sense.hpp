#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Infers from the resistance F to a motion the side on which the hand has left a corridor.
///
/// A wall is felt if F exceeds the resistance E of a free motion: F > E + just (weber E + threshold). With
/// the probability `entered` it was entered just now. Otherwise it was there before and is felt again because
/// the push has turned. That is no evidence of its side: law D2 of thesis 3.4.2 resists no inward push. With
/// the outward path r since then, the odds of the outer side are P/(1 - P) exp(l), where
///
///     P = 1/2 + entered (1/(1 + exp(-1.702 rate/wrong)) - 1/2)  (a rate with a normal error `wrong`),
///     l = ((F - W(-r))^2 - (F - W(r))^2)/(2 e^2 + 2 (slope wrong t)^2),
///     e^2 = (weber F)^2 + threshold^2 + E^2.
///
/// W(r) = offset + slope max(0, r) is the resistance of the wall after a time t. The part of the free motion
/// in F is unknown, so its error e contains E. All errors are constant while the wall is felt, so only the
/// present values count. With side = tanh of half the logarithm of the odds and d = (F - offset)/slope, the
/// hand is at side (half + d). Its variance contains the other side and the error of the felt force.
///
/// A `held` hand feels at most its own push, so the wall resists with F or more. Then l = log(Phi((W(r) -
/// F)/e)/Phi((W(-r) - F)/e)) with the normal distribution Phi, and e^2 includes (slope wrong t)^2.
struct WallSense {
  double weber = 0.1, threshold = 0.0, just = 3.0, wrong = 1.0;
  double offset = 0.0, slope = 1.0, half = 0.0;
  double entered = 1.0;
  Input<1> resistance{}, free{}, rate{}, held{};
  Output<1> outside{}, side{}, measured{}, precision{};
  DiscreteState<1> first{}, way{}, since{};  ///< log(P/(1 - P)), r and t at the last tick; t is 0 inside
  Period period;

  void outputs() {
    outside = resistance > free + just * (weber * free + threshold) ? 1.0 : 0.0;
    side = outside != 0.0 ? fn::tanh(0.5 * now()) : 0.0;
    const double far = half + std::max(0.0, (resistance - offset) / slope), blur = error() / slope;
    measured = side * far;
    precision = outside != 0.0 ? 1.0 / ((1.0 - side * side) * far * far + blur * blur) : 0.0;
  }

  void update() {
    const bool is = outside != 0.0;
    if (since == 0.0) first = is ? as_it_began() : 0.0;
    way = is && since > 0.0 ? moved() : 0.0;
    since = is ? since + period : 0.0;
  }

  static void declare(Declare<WallSense>& is);

 private:
  double error() const { return fn::hypot(weber * resistance, threshold, static_cast<double>(free)); }
  double moved() const { return way + rate * period; }
  double wall(double out) const { return offset + slope * std::max(0.0, out); }

  double as_it_began() const {
    constexpr double logistic = 1.702;
    const double p = 0.5 + entered * (1.0 / (1.0 + fn::exp(-logistic * rate / wrong)) - 0.5);
    return limited(fn::log(p / (1.0 - p)));
  }

  double now() const {
    if (since == 0.0) return as_it_began();
    const double outer = resistance - wall(moved()), inner = resistance - wall(-moved());
    const double doubt = slope * wrong * since, square = error() * error() + doubt * doubt;
    if (held.connected() && held != 0.0)
      return limited(first + log_probability(-outer / std::sqrt(square)) -
                     log_probability(-inner / std::sqrt(square)));
    return limited(first + (inner * inner - outer * outer) / (2.0 * square));
  }

  /// Returns log Phi(z), with a lower bound for limited().
  static double log_probability(double z) {
    return fn::log(std::max(1e-12, 0.5 * fn::erfc(-z * std::sqrt(0.5))));
  }

  static double limited(double odds) { return std::clamp(odds, -8.0, 8.0); }
};

}  // namespace stepwire
