#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// What the resistance F to a motion tells of the side on which one has left a corridor. F stands out from
/// the resistance E of a free motion where F > E + just (weber E + threshold). A wall that is felt was
/// entered with the probability `entered`; else it was there before, and is felt again since the push has
/// turned (law D2 of thesis 3.4.2 resists no push inward), which is no evidence of its side. With the way r
/// that was felt outward since then the odds of the outer side are P/(1 - P) exp(l), where
///
///     P = 1/2 + entered (1/(1 + exp(-1.702 rate/wrong)) - 1/2)  (a rate with a normal error `wrong`),
///     l = ((F - W(-r))^2 - (F - W(r))^2)/(2 e^2 + 2 (slope wrong t)^2),
///     e^2 = (weber F)^2 + threshold^2 + E^2.
///
/// W(r) = offset + slope max(0, r) is what the wall would resist by then, a time t after. How much of F is
/// that of a free motion cannot be felt, hence E in its error e. All errors last as long as the wall is felt,
/// so that what was felt before adds nothing to what is felt now. With side = tanh of half the logarithm of
/// the odds and d = (F - offset)/slope the hand is at side (half + d), with the variance of the other side
/// and of the felt force. A hand that is `held` feels no more than it pushes: the wall resists F or more, and
/// with Phi the normal distribution l = log(Phi((W(r) - F)/e)/Phi((W(-r) - F)/e)), e^2 with the doubt as
/// above.
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
    side = outside != 0.0 ? std::tanh(0.5 * now()) : 0.0;
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
  double error() const { return std::hypot(weber * resistance, threshold, static_cast<double>(free)); }
  double moved() const { return way + rate * period; }
  double wall(double out) const { return offset + slope * std::max(0.0, out); }

  double as_it_began() const {
    constexpr double logistic = 1.702;
    const double p = 0.5 + entered * (1.0 / (1.0 + std::exp(-logistic * rate / wrong)) - 0.5);
    return limited(std::log(p / (1.0 - p)));
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

  /// log Phi(z), of which no less counts than what limited() leaves.
  static double log_probability(double z) {
    return std::log(std::max(1e-12, 0.5 * std::erfc(-z * std::sqrt(0.5))));
  }

  static double limited(double odds) { return std::clamp(odds, -8.0, 8.0); }
};

}  // namespace stepwire
