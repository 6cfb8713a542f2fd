#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Posterior probability of the direction psi of a region, on 72 headings.
///
/// Each displayed direction mu with precision k contributes a von Mises likelihood, exp(k cos(psi - mu)). At
/// each judgement, the resistance F to a push along phi contributes by the second law of directionality
///
///     p(psi) <- p(psi)^(1 - forgetting) N(F; max(E, F_max g), (weber F_expected)^2 + (unsure E)^2),
///     g = |sin(phi - psi)|, and 1 beyond 90 degrees,
///
/// with the resistance E of a free motion. Mirrored directions have equal likelihoods; without a force there
/// is no contribution. While the hand is held, the resistance is known to be at least F, and N is the
/// probability of that.
struct HeadingPosterior {
  static constexpr Index headings = 72;

  double weber = 0.1, unsure = 0.3, forgetting = 0.1, threshold = 0.0, within = 0.5, change = 1.0;
  Inputs direction{}, precision{};
  Input<1> force{}, push{}, maximum{}, free{}, moving{}, judged{};
  Output<1> heading{}, deviation{}, sure{};
  DiscreteState<headings> felt{};  ///< log-likelihood of all felt resistances
  DiscreteState<3> last{};         ///< heading, deviation and sure of the last judgement

  void outputs() {
    if (judged != 0.0) return judge();
    heading = last[0];
    deviation = last[1];
    sure = last[2];
  }

  void update() {
    last[0] = heading;
    last[1] = deviation;
    last[2] = sure;
    if (judged == 0.0) return;
    const std::array<double, headings> now = felt_now();
    const double most = *std::max_element(now.begin(), now.end());
    felt.each([&](Index k) { return now[static_cast<std::size_t>(k)] - most; });
  }

  void configure(Configure& is);
  static void declare(Declare<HeadingPosterior>& is);

 private:
  static constexpr double turn = 6.283185307179586477;
  static double angle(Index k) { return turn * static_cast<double>(k) / static_cast<double>(headings); }
  static double difference(double a, double b) { return std::remainder(a - b, turn); }

  void judge() {
    std::array<double, headings> p = felt_now();
    for (Index cue = 0; cue < direction.count(); ++cue)
      if (const double precise = precision.first(cue); precise > 0.0)
        for (Index k = 0; k < headings; ++k)
          p[static_cast<std::size_t>(k)] += precise * fn::cos(angle(k) - direction.first(cue));
    const double most = *std::max_element(p.begin(), p.end());
    double total = 0.0;
    for (double& each : p) total += each = fn::exp(each - most);
    for (double& each : p) each /= total;
    describe(p);
  }

  /// Returns the most probable heading; the last one unless the new one is at least `change` times as
  /// probable.
  Index chosen(const std::array<double, headings>& p) const {
    const Index best = std::max_element(p.begin(), p.end()) - p.begin();
    const auto steps = static_cast<Index>(std::lround(last[0] / angle(1)));
    const Index current = (steps % headings + headings) % headings;
    const auto at = [&](Index k) { return p[static_cast<std::size_t>(k)]; };
    return at(best) < change * at(current) ? current : best;
  }

  /// Computes the outputs: the chosen heading, averaged with its neighbours, the circular standard deviation,
  /// and the probability within `within` of it.
  void describe(const std::array<double, headings>& p) {
    constexpr Index beside = 3;
    const Index best = chosen(p);
    double weight = 0.0, moment = 0.0, x = 0.0, y = 0.0;
    for (Index k = -beside; k <= beside; ++k) {
      const double each = p[static_cast<std::size_t>((best + k + headings) % headings)];
      weight += each;
      moment += each * angle(1) * static_cast<double>(k);
    }
    heading = difference(angle(best) + moment / weight, 0.0);
    sure = 0.0;
    for (Index k = 0; k < headings; ++k) {
      const double each = p[static_cast<std::size_t>(k)];
      x += each * fn::cos(angle(k));
      y += each * fn::sin(angle(k));
      sure = sure + each * share_within(std::abs(difference(angle(k), heading)));
    }
    deviation = std::sqrt(-2.0 * fn::log(std::clamp(fn::hypot(x, y), 1e-12, 1.0)));
  }

  /// Returns the share of the cell about a heading at the distance `away` from the chosen one that is within
  /// `within`.
  double share_within(double away) const { return std::clamp(0.5 + (within - away) / angle(1), 0.0, 1.0); }

  std::array<double, headings> felt_now() const {
    std::array<double, headings> now{};
    const bool feels = maximum > 0.0 && force > 0.0;
    for (Index k = 0; k < headings; ++k)
      now[static_cast<std::size_t>(k)] =
          feels ? (1.0 - forgetting) * felt[k] + likelihood(std::abs(difference(angle(k), push)))
                : static_cast<double>(felt[k]);
    return now;
  }

  /// Returns the log-likelihood up to a constant. A held hand feels at most its own push.
  double likelihood(double away) const {
    constexpr double quarter = turn / 4.0, root_of_two = 1.4142135623730951, least = 1e-12;
    const double gain = away < quarter ? fn::sin(away) : 1.0;
    const double expected = std::max(static_cast<double>(free), maximum * gain);
    const double square =
        weber * weber * expected * expected + unsure * unsure * free * free + threshold * threshold;
    const double z = (force - expected) / std::sqrt(square);
    if (moving == 0.0) return fn::log(std::max(least, 0.5 * fn::erfc(z / root_of_two)));
    return -0.5 * (z * z + fn::log(square));
  }
};

}  // namespace stepwire
