#pragma once

#include <algorithm>
#include <cmath>

#include "blocks/plants/bouc_wen_law.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Common part of the linear and the rotary MR damper: its law and its energy balance. The resistance is k0 x
/// + c(i) v + alpha(i) z + f0, with z from the Bouc-Wen law. Displacement is a length or an angle, resistance
/// a force or a torque.
///
/// The energy balance is exact for a current that changes in steps or smoothly:
///
///     integral of (c v + alpha z) v = stored + dissipated - switching_work   (all from the start of the run)
///
/// with stored = alpha z^2 / (2 A). The switching_work is the integral of dalpha/dt z^2 / (2 A): the energy
/// that a change of the current at z != 0 adds to the stored one, which is unphysical.
struct MRDamperCore {
  enum class Outside { hold, raw };
  enum class Integration { solver, exact };

  double A = 1.0, beta = 0.5, gamma = 0.5, n = 1.0;
  double z_max = 0.0, ratio = 0.0;  ///< limit of z, gamma/beta; 0: beta, gamma apply
  Numbers alpha, c, current_range;
  double k0 = 0.0, f0 = 0.0;
  Outside extrapolate = Outside::hold;
  Integration integration = Integration::solver;

  Input<1> velocity{}, current{}, position{};
  Output<1> z{}, dissipated{}, stored{}, switching_work{};
  State<1> evolution{}, loss{}, spring_work{};
  DiscreteState<1> last_time{}, last_velocity{}, last_current{}, earlier_current{}, first_stored{}, begun{};
  Time time{};
  Diagnostic outside_range{};
  BoucWenFactors factors{};            ///< effective coefficients in SI
  Numbers scaled_alpha{}, scaled_c{};  ///< alpha and c in SI

  void configure(Configure& is);

  /// Evaluates a polynomial with descending coefficients.
  static double polynomial(const Numbers& coefficients, double i) {
    double sum = 0.0;
    STEPWIRE_UNROLLED
    for (Index k = 0; k < coefficients.size(); ++k) sum = sum * i + coefficients[k];
    return sum;
  }

 protected:
  /// Energies since the start of the run, and z, at this instant.
  struct Account {
    double z, loss, spring_work;
  };

  /// Computes the effective parameters: `factor` converts alpha and c into SI, `stiffening` shortens the
  /// pre-sliding.
  void scale(double factor, double stiffening) {
    factors = z_max > 0.0 ? BoucWenLaw::of_limit(A * stiffening, z_max, ratio, n)
                          : BoucWenFactors{A * stiffening, beta * stiffening, gamma * stiffening};
    scaled_alpha = alpha.map([&](double one) { return one * factor; });
    scaled_c = c.map([&](double one) { return one * factor; });
  }

  /// Writes the energies and z, and returns the resistance.
  double write_account() {
    const Account now = account();
    const double i = acting(current), slope = polynomial(scaled_alpha, i);
    const double held = 0.5 * slope / factors.A * now.z * now.z;
    z = now.z;
    dissipated = now.loss;
    stored = held;
    switching_work = held - (begun == 0.0 ? held : first_stored) - now.spring_work;
    const double force = polynomial(scaled_c, i) * velocity + slope * now.z + f0;
    return position.connected() ? force + k0 * position : force;
  }

  void write_rates() {
    if (integration == Integration::exact) {
      evolution.derivative = spring_work.derivative = loss.derivative = 0.0;
      return;
    }
    const double i = acting(current), rate = law().rate(velocity, evolution);
    const double stiffness = 2.0 * spring(i), viscous = polynomial(scaled_c, i) * velocity * velocity;
    evolution.derivative = rate;
    spring_work.derivative = stiffness * evolution * rate;
    loss.derivative = viscous + stiffness * law().lost(velocity, evolution);
  }

  void remember() {
    if (!within_range(current)) outside_range.raise(time);
    const bool first = begun == 0.0;
    if (first) first_stored = stored;
    begun = 1.0;
    if (integration == Integration::solver) return;
    spring_work = spring_work_at(z, spring_of_way());
    evolution = z;  // the outputs of this tick have already advanced it
    loss = dissipated;
    earlier_current = first ? acting(current) : double(last_current);
    last_time = time;
    last_velocity = velocity;
    last_current = acting(current);
  }

  /// True within the range, with a margin for rounding, so that a saturation at its end raises no diagnostic.
  bool within_range(double i) const {
    const double hair = 1e-9 * (current_range[1] - current_range[0]);
    return i >= current_range[0] - hair && i <= current_range[1] + hair;
  }

 private:
  double acting(double i) const {
    return extrapolate == Outside::raw ? i : std::clamp(i, current_range[0], current_range[1]);
  }

  BoucWenLaw law() const { return {factors, n}; }

  /// Returns alpha / (2 A).
  double spring(double i) const { return 0.5 * polynomial(scaled_alpha, i) / factors.A; }

  /// Returns the current at the end of the interval since the last tick, assumed linear in it. A jump falls
  /// on a tick and takes effect after the interval. A change therefore counts as linear only if it continues
  /// the previous one, and only up to that size.
  double current_behind_way() const {
    const double before = last_current - earlier_current, now = acting(current) - last_current;
    if (!(before * now > 0.0)) return last_current;
    return last_current + (std::abs(before) < std::abs(now) ? before : now);
  }

  /// Returns the energies and z. With exact integration the states keep the last tick's values, and each call
  /// integrates from there. The current does not affect z; the error of its weights is of second order in the
  /// step.
  Account account() const {
    if (integration == Integration::solver) return {evolution, loss, spring_work};
    const double duration = time - last_time, v0 = last_velocity, v1 = velocity;
    const BoucWenLaw::Travelled way = law().over(evolution, v0, v1, duration);
    const double i0 = last_current, i1 = current_behind_way();
    const double c0 = polynomial(scaled_c, i0), c1 = polynomial(scaled_c, i1);
    const double viscous = 0.5 * (c0 + c1) * duration * (v0 * v0 + v0 * v1 + v1 * v1) / 3.0 +
                           (c1 - c0) * duration * (v1 * v1 - v0 * v0) / 12.0;
    const double elastic = spring_of_way();
    return {way.z, loss + viscous + 2.0 * elastic * way.lost, spring_work_at(way.z, elastic)};
  }

  /// Returns the mean of alpha / (2 A) since the last tick.
  double spring_of_way() const { return 0.5 * (spring(last_current) + spring(current_behind_way())); }

  double spring_work_at(double end, double elastic) const {
    return spring_work + elastic * (end - evolution) * (end + evolution);
  }
};

}  // namespace stepwire
