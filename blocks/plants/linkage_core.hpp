#pragma once

#include <array>
#include <type_traits>

#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Set of n telescopic links from anchors on the ground to one pin, on a line, in the plane or in space. A
/// link is a housing that rotates about its anchor and a rod that slides in it and ends at the pin. Both are
/// thin and straight; joints have no friction, and there is no gravity.
///
/// Notation: p is the pin's position, e the unit vector along a link, l its length. The velocity across it is
/// w = v - (e.v) e. Its inertia about the anchor is J(l) = housing_inertia + rod_inertia + rod_mass (l -
/// rod_centre)^2. Then
///
///     T = 1/2 pin_mass v^2 + sum over links of 1/2 rod_mass (e.v)^2 + 1/2 J(l)/l^2 w^2
///     M(p) a + h(p, v) = external + sum of force e + torque/l n            (Lagrange's equations of T)
///     M = pin_mass 1 + sum of rod_mass e e^T + mu (1 - e e^T),  mu(l) = J/l^2
///     h = sum of rod_mass rod_centre w^2/l^2 e + mu' (e.v) w
///
/// A torque about an anchor, in the plane, acts at the pin along n, which is e rotated left by a right angle.
struct LinkageCore {
  using Vector = std::array<double, 3>;  ///< on a line and in the plane, further elements are 0

  Matrix anchors;
  PerElement rod_mass = 0.0, rod_inertia = 0.0, rod_centre = 0.0, housing_inertia = 0.0;
  double pin_mass = 0.0;
  PerElement shortest = 0.0, longest = unlimited;
  Input<> force{}, torque{};
  Output<> length{}, rate{}, angular_rate{};
  Output<1> kinetic_energy{};
  DiscreteState<1> strayed{}, strayed_length{};
  Diagnostic out_of_stroke{};
  Time time{};

  void configure(Configure& is);

 protected:
  /// State of a link at an instant.
  struct Link {
    double length = 0.0, rate = 0.0;
    Vector along{};        ///< unit vector from the anchor to the pin; 0 if they coincide
    Vector across{};       ///< velocity of the pin across the link
    double turning = 0.0;  ///< square of that velocity
  };

  /// Equations M a = load: the forces on the pin minus h.
  struct Balance {
    std::array<Vector, 3> mass{};
    Vector load{};
  };

  Index links() const { return anchors.rows(); }
  Index dimensions() const { return anchors.columns(); }

  template <Index dimension>
  using Dimension = std::integral_constant<Index, dimension>;

  template <Index n, class Position, class Velocity>
  Link link(Dimension<n>, Index k, const Position& position, const Velocity& velocity) const {
    Link is;
    SumOfSquares squares;
    for (Index i = 0; i < n; ++i) {
      at(is.along, i) = position[i] - anchors(k, i);
      squares.add(at(is.along, i));
    }
    is.length = squares.root();
    for (Index i = 0; is.length > 0.0 && i < n; ++i) {
      at(is.along, i) /= is.length;
      is.rate += at(is.along, i) * velocity[i];
    }
    for (Index i = 0; i < n; ++i) {
      at(is.across, i) = velocity[i] - is.rate * at(is.along, i);
      is.turning += at(is.across, i) * at(is.across, i);
    }
    return is;
  }

  /// Calls visit(dimension, k, link) for each link. The dimension is a constant of the compiler, so that
  /// loops over elements are unrolled.
  template <class Position, class Velocity, class Visitor>
  void for_each_link(const Position& position, const Velocity& velocity, const Visitor& visit) const {
    const auto walk = [&](auto dimension) {
      for (Index k = 0; k < links(); ++k) visit(dimension, k, link(dimension, k, position, velocity));
    };
    if (dimensions() == 1) return walk(Dimension<1>{});
    if (dimensions() == 2) return walk(Dimension<2>{});
    walk(Dimension<3>{});
  }

  template <class Velocity>
  void begin_energy(const Velocity& velocity) {
    double square = 0.0;
    for (Index i = 0; i < dimensions(); ++i) square += velocity[i] * velocity[i];
    kinetic_energy = 0.5 * pin_mass * square;
  }

  template <Index n>
  void write_link(Dimension<n>, Index k, const Link& now) {
    length[k] = now.length;
    rate[k] = now.rate;
    angular_rate[k] = 0.0;
    if (now.length == 0.0) return;
    if (n == 2) angular_rate[k] = (now.along[0] * now.across[1] - now.along[1] * now.across[0]) / now.length;
    kinetic_energy =
        kinetic_energy + 0.5 * (rod_mass[k] * now.rate * now.rate + mass_across(k, now.length) * now.turning);
  }

  /// Returns the equations of the pin without links.
  Balance begin_balance() const {
    Balance sum;
    for (Index i = 0; i < dimensions(); ++i) at(row(sum, i), i) = pin_mass;
    return sum;
  }

  /// Adds a link's part of M, its force, and minus its part of h; no effect for a link of length 0.
  template <Index n>
  void add_link(Dimension<n>, Index k, const Link& now, Balance& sum) const {
    if (now.length == 0.0) return;
    const double l = now.length, across = mass_across(k, l), along = rod_mass[k] - across;
    const double pull = force[k] - rod_mass[k] * rod_centre[k] * now.turning / (l * l);
    const double drag = slope_of_mass_across(k, l) * now.rate;
    for (Index i = 0; i < n; ++i) {
      at(row(sum, i), i) += across;
      for (Index j = 0; j < n; ++j) at(row(sum, i), j) += along * at(now.along, i) * at(now.along, j);
      at(sum.load, i) += pull * at(now.along, i) - drag * at(now.across, i);
    }
    if (!torque.connected()) return;
    sum.load[0] -= torque[k] / l * now.along[1];
    sum.load[1] += torque[k] / l * now.along[0];
  }

  void watch_stroke() {
    for (Index k = 0; k < links() && !out_of_stroke.raised(); ++k) {
      if (length[k] > 0.0 && length[k] >= shortest[k] && length[k] <= longest[k]) continue;
      strayed = static_cast<double>(k + 1);
      strayed_length = length[k];
      out_of_stroke.raise(time);
    }
  }

  static double& at(Vector& vector, Index i) { return vector[static_cast<std::size_t>(i)]; }
  static double at(const Vector& vector, Index i) { return vector[static_cast<std::size_t>(i)]; }
  static Vector& row(Balance& balance, Index i) { return balance.mass[static_cast<std::size_t>(i)]; }

 private:
  double inertia(Index k, double l) const {
    const double arm = l - rod_centre[k];
    return housing_inertia[k] + rod_inertia[k] + rod_mass[k] * arm * arm;
  }
  /// Returns mu, the effective mass of the link at the pin, across it.
  double mass_across(Index k, double l) const { return inertia(k, l) / (l * l); }
  double slope_of_mass_across(Index k, double l) const {
    return 2.0 * (rod_mass[k] * (l - rod_centre[k]) - inertia(k, l) / l) / (l * l);
  }
};

}  // namespace stepwire
