#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

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
  template <Index dimension>
  using Dimension = std::integral_constant<Index, dimension>;
  template <Index n>
  using Vector = std::array<double, static_cast<std::size_t>(n)>;

  /// State of a link at an instant.
  template <Index n>
  struct Link {
    double length = 0.0, rate = 0.0;
    Vector<n> along{};     ///< unit vector from the anchor to the pin; 0 if they coincide
    Vector<n> across{};    ///< velocity of the pin across the link
    double turning = 0.0;  ///< square of that velocity
    double inertia = 0.0;  ///< J
    double mass = 0.0;     ///< mu; 0 without length
  };

  /// Equations M a = load: the forces on the pin minus h.
  template <Index n>
  struct Balance {
    std::array<Vector<n>, static_cast<std::size_t>(n)> mass{};
    Vector<n> load{};
  };

  Index links() const { return anchors.rows(); }
  Index dimensions() const { return anchors.columns(); }

  /// Calls visit(dimension), a constant of the compiler.
  template <class Visitor>
  void in_dimension(const Visitor& visit) const {
    if (dimensions() == 1) return visit(Dimension<1>{});
    if (dimensions() == 2) return visit(Dimension<2>{});
    visit(Dimension<3>{});
  }

  template <Index n, class Position, class Velocity>
  Link<n> link(Dimension<n>, Index k, const Position& position, const Velocity& velocity) const {
    Link<n> is;
    unrolled<n>([&](Index i) { at(is.along, i) = position[i] - anchors(k, i); });
    is.length = norm(is.along);
    if (is.length > 0.0) set_along(k, velocity, is);
    unrolled<n>([&](Index i) {
      at(is.across, i) = velocity[i] - is.rate * at(is.along, i);
      is.turning += at(is.across, i) * at(is.across, i);
    });
    return is;
  }

  /// Returns the kinetic energy of the pin without links.
  template <Index n, class Velocity>
  double energy_of_pin(Dimension<n>, const Velocity& velocity) const {
    double square = 0.0;
    unrolled<n>([&](Index i) { square += velocity[i] * velocity[i]; });
    return 0.5 * pin_mass * square;
  }

  /// Writes the outputs of a link and adds its kinetic energy.
  template <Index n>
  void write_link(Index k, const Link<n>& now, double& energy) {
    length[k] = now.length;
    rate[k] = now.rate;
    angular_rate[k] = 0.0;
    if (now.length == 0.0) return;
    if constexpr (n == 2)
      angular_rate[k] = (now.along[0] * now.across[1] - now.along[1] * now.across[0]) / now.length;
    energy = energy + 0.5 * (rod_mass[k] * now.rate * now.rate + now.mass * now.turning);
  }

  /// Adds the pin's own mass to its equations.
  template <Index n>
  void add_pin(Balance<n>& sum) const {
    unrolled<n>([&](Index i) { at(row(sum, i), i) += pin_mass; });
  }

  /// Adds a link's part of M, its force, and minus its part of h; no effect for a link of length 0.
  template <Index n>
  void add_link(Index k, const Link<n>& now, Balance<n>& sum) const {
    if (now.length == 0.0) return;
    const double l = now.length, across = now.mass, along = rod_mass[k] - across;
    const double pull = force[k] - rod_mass[k] * rod_centre[k] * now.turning / (l * l);
    const double drag = slope_of_mass_across(k, now) * now.rate;
    unrolled<n>([&](Index i) {
      at(row(sum, i), i) += across;
      unrolled<n>([&](Index j) { at(row(sum, i), j) += along * at(now.along, i) * at(now.along, j); });
      at(sum.load, i) += pull * at(now.along, i) - drag * at(now.across, i);
    });
    if constexpr (n == 2) {
      if (!torque.connected()) return;
      sum.load[0] -= torque[k] / l * now.along[1];
      sum.load[1] += torque[k] / l * now.along[0];
    }
  }

  void watch_stroke() {
    for (Index k = 0; k < links() && !out_of_stroke.raised(); ++k) {
      if (length[k] > 0.0 && length[k] >= shortest[k] && length[k] <= longest[k]) continue;
      strayed = static_cast<double>(k + 1);
      strayed_length = length[k];
      out_of_stroke.raise(time);
    }
  }

  /// Calls visit(i) for each i below n, without a loop. The elements of vectors are then in registers. In
  /// memory a number that was just written would be read as one of a pair, for which a processor waits.
  template <Index n, class Visitor>
  static void unrolled(const Visitor& visit) {
    [&]<Index... i>(std::integer_sequence<Index, i...>) {
      (visit(i), ...);
    }
    (std::make_integer_sequence<Index, n>{});
  }

  template <class Elements>
  static auto& at(Elements& elements, Index i) {
    return elements[static_cast<std::size_t>(i)];
  }
  template <Index n>
  static Vector<n>& row(Balance<n>& balance, Index i) {
    return at(balance.mass, i);
  }

 private:
  /// Returns the length of a vector. On a line it needs neither root nor scale, and lanes no branch.
  template <std::size_t n>
  static double norm(const std::array<double, n>& vector) {
    if constexpr (n == 1) return std::abs(vector[0]);
    double square = 0.0;
    unrolled<static_cast<Index>(n)>([&](Index i) { square += at(vector, i) * at(vector, i); });
    // The plain root has the same bits, where squares are far from overflow and underflow.
    if (square > 1e-200 && square < 1e200) return std::sqrt(square);
    return length_of(n, [&](std::size_t i) { return vector[i]; });
  }

  /// Sets the direction of a link of some length, where `along` is the vector to the pin, and its inertia.
  template <Index n, class Velocity>
  void set_along(Index k, const Velocity& velocity, Link<n>& is) const {
    unrolled<n>([&](Index i) {
      at(is.along, i) /= is.length;
      is.rate += at(is.along, i) * velocity[i];
    });
    const double arm = is.length - rod_centre[k];
    is.inertia = housing_inertia[k] + rod_inertia[k] + rod_mass[k] * arm * arm;
    is.mass = is.inertia / (is.length * is.length);
  }
  /// Returns mu'(l), the derivative of the effective mass.
  template <Index n>
  double slope_of_mass_across(Index k, const Link<n>& now) const {
    const double l = now.length;
    return 2.0 * (rod_mass[k] * (l - rod_centre[k]) - now.inertia / l) / (l * l);
  }
};

}  // namespace stepwire
