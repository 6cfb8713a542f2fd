#pragma once

#include <string>

#include "blocks/plants/mr_damper_core.hpp"

namespace stepwire {

/// Units of a kind of MR damper.
struct MRDamperUnits {
  std::string displacement, velocity, resistance, stiffness;
  std::string per_displacement;  ///< unit of beta and gamma for n = 1
  std::string alpha, c;
};

template <>
struct Literal<BoucWenFactors> {
  static std::string text(const BoucWenFactors& factors, LiteralWriter& writer) {
    std::string text = "{" + writer.number(factors.A);
    for (const double factor : {factors.beta, factors.gamma}) text += ", " + writer.number(factor);
    return text + "}";
  }
};

template <>
struct PreparedParts<BoucWenFactors> {
  static constexpr bool by_element = false;
  static Index count(const BoucWenFactors&) { return 3; }
  static std::string text(Index k) {
    constexpr const char* names[] = {".A", ".beta", ".gamma"};
    return names[k];
  }
  static void put(BoucWenFactors& factors, const double* numbers, Index) {
    factors = {numbers[0], numbers[1], numbers[2]};
  }
};

/// Declares the common parameters, ports and states of both MR dampers.
template <class Damper>
void declare_mr_damper(Declare<Damper>& is, const MRDamperUnits& units) {
  is.template parameter<&Damper::A>({.doc = "initial slope dz/dx of the evolution", .above = 0.0});
  is.template parameter<&Damper::beta>(
      {.unit = units.per_displacement,
       .doc = "factor of |v| |z|^(n-1) z; for n other than 1 a bare SI number",
       .at_least = 0.0});
  is.template parameter<&Damper::gamma>(
      {.unit = units.per_displacement,
       .doc = "factor of v |z|^n, in the unit of beta; |gamma| must not exceed beta"});
  is.template parameter<&Damper::z_max>({.unit = units.displacement,
                                         .doc = "the limit of z in a steady motion, (A/(beta + "
                                                "gamma))^(1/n), in the place of beta and gamma, whose "
                                                "unit hangs on n; 0: they are given",
                                         .at_least = 0.0});
  is.template parameter<&Damper::ratio>(
      {.doc = "gamma/beta, where z_max is given", .above = -1.0, .at_most = 1.0});
  is.template parameter<&Damper::n>({.doc = "sharpness of the knee", .at_least = 1.0});
  is.template parameter<&Damper::alpha>(
      {.unit = units.alpha, .doc = "alpha(i), a polynomial in the current in amperes, highest power first"});
  is.template parameter<&Damper::c>(
      {.unit = units.c, .doc = "c(i), a polynomial in the current in amperes, highest power first"});
  is.template parameter<&Damper::k0>(
      {.unit = units.stiffness, .doc = "stiffness beside the damper (a gas spring)", .structural = true});
  is.template parameter<&Damper::f0>({.unit = units.resistance, .doc = "constant part of the resistance"});
  is.template parameter<&Damper::current_range>(
      {.unit = "A", .doc = "lowest and highest current at which the polynomials were identified"});
  is.template parameter<&Damper::extrapolate>(
      {.doc =
           "outside current_range: hold the coefficients of its nearer end, or evaluate the polynomials raw "
           "(which are no damper far outside: c turns negative and energy comes out)",
       .words = {"hold", "raw"}});
  is.template parameter<&Damper::integration>(
      {.doc = "how z follows the velocity: by the diagram's solver, for any n, whose step must resolve "
              "1/((beta + |gamma|) |v|); or from tick to tick for a velocity that goes in a straight line "
              "between them, which is stable with any step: by the exact solution for n = 1, by as many "
              "sub-steps as it takes (to some 1e-6 of the limit of z) for other n",
       .words = {"solver", "exact"}});

  is.template input<&Damper::velocity>({.unit = units.velocity, .doc = "velocity v"});
  is.template input<&Damper::current>({.unit = "A", .doc = "current i in the coil"});
  is.template input<&Damper::position>(
      {.unit = units.displacement, .doc = "displacement x; needed where k0 is not 0", .optional = true});
  is.template output<&Damper::z>({.unit = units.displacement, .doc = "evolutionary variable"});
  is.template output<&Damper::dissipated>(
      {.unit = "J", .doc = "energy turned into heat since the start; never falls"});
  is.template output<&Damper::stored>(
      {.unit = "J", .doc = "energy stored in the pre-sliding, alpha z^2 / (2 A)"});
  is.template output<&Damper::switching_work>(
      {.unit = "J",
       .doc = "work of current changes, the integral of dalpha/dt z^2 / (2 A). The damper is passive beyond "
              "it: the "
              "integral of (c v + alpha z) v is the rise of stored, plus dissipated, minus switching_work"});

  is.template state<&Damper::evolution>({.unit = units.displacement, .doc = "z (exact: at the last tick)"});
  is.template state<&Damper::loss>(
      {.unit = "J", .doc = "dissipated energy (exact: at the last tick)", .settable = false});
  is.template state<&Damper::spring_work>(
      {.unit = "J", .doc = "integral of alpha z dz / A (exact: at the last tick)", .settable = false});
  is.template state<&Damper::last_time>({.unit = "s", .doc = "time of the last tick", .settable = false});
  is.template state<&Damper::last_velocity>(
      {.unit = units.velocity, .doc = "velocity then", .settable = false});
  is.template state<&Damper::last_current>(
      {.unit = "A", .doc = "current then, as it acted", .settable = false});
  is.template state<&Damper::earlier_current>(
      {.unit = "A", .doc = "current at the tick before it", .settable = false});
  is.template state<&Damper::first_stored>(
      {.unit = "J", .doc = "stored energy at the start", .settable = false});
  is.template state<&Damper::begun>({.doc = "1 from the first tick on", .settable = false});
  is.template clock<&Damper::time>();
  is.template prepared<&Damper::factors>();
  is.template prepared<&Damper::scaled_alpha>();
  is.template prepared<&Damper::scaled_c>();
  is.template diagnostic<&Damper::outside_range>(
      {.doc = "the current leaves the range at which the damper was identified (see 'extrapolate')"});
}

}  // namespace stepwire
