#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Device force for the hand, from the largest resistance F_max, which points to the authorized region, and
/// the direction d in which the hand pushes or moves:
///
///     D1, for each axis: F_out = F_max where F_max d < 0, else 0
///     D2: F_out = -|F_max| gain d/|d|, gain = sin(angle between d and F_max) up to 90 degrees, beyond it 1
///
/// In a plane, `angle` rotates the axes of D1.
struct Directionality {
  enum class Law { D1, D2 };
  enum class Direction { force, motion };

  Law law = Law::D2;
  Direction direction = Direction::force;
  double threshold = 0.0, travel = 0.3e-3;
  Input<> f_max{}, force{}, position{};
  Input<1> angle{};
  Output<> y{}, gain{};
  DiscreteState<> behind{};     ///< point that the position drags along at the distance `travel`
  DiscreteState<1> is_drawn{};  ///< 0 before the first tick

  void outputs() {
    if (law == Law::D1 && angle.connected()) return resist_on_turned_axes();
    if (law == Law::D1) {
      gain.each([&](Index i) { return f_max[i] * toward(i) < 0.0 ? 1.0 : 0.0; });
      y.each([&](Index i) { return gain[i] * f_max[i]; });
      return;
    }
    const double length = length_of_direction(), most = length_of(f_max);
    const double share = length > 0.0 && most > 0.0 ? share_of_angle(length, most) : 0.0;
    gain.each([&](Index) { return share; });
    y.each([&](Index i) { return share > 0.0 ? -most * share / length * toward(i) : 0.0; });
  }

  void update() {
    if (direction == Direction::force) return;
    SumOfSquares squares;
    for (Index i = 0; i < position.size(); ++i) squares.add(way(i));
    const double scaled_travel = squares.scale() * travel;
    const double share = squares.scaled() > scaled_travel * scaled_travel ? travel / squares.root() : 1.0;
    behind.each([&](Index i) { return position[i] - share * way(i); });
    is_drawn = 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<Directionality>& is);

 private:
  void resist_on_turned_axes() {
    const double c = fn::cos(angle), s = fn::sin(angle);
    const double most[2] = {c * f_max[0] + s * f_max[1], c * f_max[1] - s * f_max[0]};
    const double push[2] = {pushed(c * hand(0) + s * hand(1)), pushed(c * hand(1) - s * hand(0))};
    double out[2] = {};
    for (Index i = 0; i < 2; ++i) {
      gain[i] = most[i] * push[i] < 0.0 ? 1.0 : 0.0;
      out[i] = gain[i] * most[i];
    }
    y[0] = c * out[0] - s * out[1];
    y[1] = s * out[0] + c * out[1];
  }

  double hand(Index i) const { return direction == Direction::motion ? way(i) : force[i]; }

  /// Returns a component of a force, or 0 if it is not above the threshold.
  double pushed(double part) const {
    return direction == Direction::motion || std::abs(part) > threshold ? part : 0.0;
  }

  double way(Index i) const { return is_drawn == 0.0 ? 0.0 : position[i] - behind[i]; }

  /// Returns a component of the direction of the hand; 0 for a force that is not above the threshold.
  double toward(Index i) const { return law == Law::D1 ? pushed(hand(i)) : hand(i); }

  double length_of_direction() const {
    const double length = stepwire::length_of(f_max.size(), [&](Index i) { return toward(i); });
    return direction == Direction::force && !(length > threshold) ? 0.0 : length;
  }

  static double length_of(const Input<>& vector) {
    return stepwire::length_of(vector.size(), [&](Index i) { return static_cast<double>(vector[i]); });
  }

  /// Returns the sine from the component of d perpendicular to F_max, which is accurate also for small
  /// angles.
  double share_of_angle(double length, double most) const {
    double along = 0.0, beside = 0.0;
    for (Index i = 0; i < f_max.size(); ++i) along += toward(i) / length * (f_max[i] / most);
    if (along <= 0.0) return 1.0;
    for (Index i = 0; i < f_max.size(); ++i) {
      const double rest = toward(i) / length - along * (f_max[i] / most);
      beside += rest * rest;
    }
    return beside < 1.0 ? std::sqrt(beside) : 1.0;
  }
};

}  // namespace stepwire
