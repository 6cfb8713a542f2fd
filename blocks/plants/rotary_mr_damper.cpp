#include "blocks/plants/rotary_mr_damper.hpp"

#include "engine/model/block/declare.hpp"

#include "blocks/plants/mr_damper_declare.hpp"

namespace stepwire {

void RotaryMRDamper::declare(Declare<RotaryMRDamper>& is) {
  is.block(
      "RotaryMRDamper",
      {.doc =
           "Rotary magnetorheological damper, T = k0 x + c(i) v + alpha(i) z + f0 with "
           "dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n over the angle x in rad. alpha and c are bare "
           "numbers in torque_unit (c: torque_unit s). Left out, a parameter is that of the RD-2087-01. "
           "Assumed, since the thesis does not say: its torque is in lbf in; below 0.50 A, the lowest "
           "current tested, its polynomials are used as they are (0.24 N m at 0 A). "
           "Refused is what is no damper: A <= 0, |gamma| > beta, alpha or c negative within current_range.",
       .source = "thesis eq. 8-10",
       .at_end = true,
       .smooth = true});
  declare_mr_damper(is, {.displacement = "rad",
                         .velocity = "rad/s",
                         .resistance = "N m",
                         .stiffness = "N m",
                         .per_displacement = "1",
                         .alpha = "1",
                         .c = "s"});
  is.parameter<&RotaryMRDamper::torque_unit>(
      {.doc = "unit in which alpha and c were identified; 1 lbf in is 0.1129848 N m",
       .words = {"lbf.in", "N m", "N cm", "lbf.ft"}});
  is.parameter<&RotaryMRDamper::presliding_scale>({.doc =
                                                       "multiplies A, beta and gamma: z and the torque keep "
                                                       "their limits but build up over an angle that is "
                                                       "smaller by this factor. 1: as printed, a spring over "
                                                       "8.5 degrees; 57.3: the printed values per degree",
                                                   .above = 0.0});
  is.parameter<&RotaryMRDamper::assumed_below>(
      {.unit = "A",
       .doc = "lowest current of the tests; below, the polynomials are used and a notice says so"});
  const std::string rating = "; of the data sheet, for figures and claims: no run depends on it";
  is.parameter<&RotaryMRDamper::highest_current>({.unit = "A", .doc = "highest current" + rating});
  is.parameter<&RotaryMRDamper::highest_speed>({.unit = "rad/s", .doc = "highest speed" + rating});
  is.parameter<&RotaryMRDamper::rated_torque>({.unit = "N m", .doc = "torque at 1 A" + rating});
  is.parameter<&RotaryMRDamper::lowest_temperature>({.unit = "K", .doc = "in operation" + rating});
  is.parameter<&RotaryMRDamper::highest_temperature>({.unit = "K", .doc = "in operation" + rating});
  is.output<&RotaryMRDamper::torque>(
      {.unit = "N m", .doc = "torque that resists the motion, in the direction of v"});
  is.diagnostic<&RotaryMRDamper::assumed>(
      {.doc = "below the lowest tested current (0.50 A) the identified polynomials are assumed to hold"});
  is.preset<rd_2087_01>(
      "rd-2087-01",
      "Lord RD-2087-01 as identified in the thesis, 0.50 to 0.75 A (0 to 0.50 A assumed), with the "
      "ratings of its data sheet (thesis table 2)");
}

}  // namespace stepwire
