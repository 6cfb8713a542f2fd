#include "blocks/plants/bouc_wen.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void BoucWen::declare(Declare<BoucWen>& is) {
  is.block(
      "BoucWen",
      {.doc = "The bare Bouc-Wen element of hysteresis, dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n. "
              "In a steady motion z settles at (A / (beta + gamma))^(1/n); the initial slope dz/dx is A. "
              "Parameters are taken as they are: with beta < |gamma| or A <= 0 the element gives out energy. "
              "MRDamper and RotaryMRDamper are whole dampers that refuse this.",
       .source = "R. Bouc 1967, Y.-K. Wen 1976; thesis eq. 2",
       .smooth = true});
  is.parameter<&BoucWen::A>({.unit = "'A", .doc = "initial slope dz/dx"});
  is.parameter<&BoucWen::beta>({.unit = "*",
                                .doc = "factor of |v| |z|^(n-1) z; its unit is A's over that of z^n (1/m "
                                       "where z is a length and n is 1)"});
  is.parameter<&BoucWen::gamma>(
      {.unit = "*", .doc = "factor of v |z|^n, in the unit of beta; may be negative"});
  is.parameter<&BoucWen::z_max>(
      {.unit = "'A 'v s",
       .doc = "the limit of z in a steady motion, in the place of beta and gamma, whose "
              "unit hangs on n; 0: they are given",
       .at_least = 0.0});
  is.parameter<&BoucWen::ratio>({.doc = "gamma/beta, where z_max is given", .above = -1.0});
  is.parameter<&BoucWen::n>({.doc = "sharpness of the knee", .above = 0.0});
  is.input<&BoucWen::velocity>({.unit = "'v", .doc = "velocity of the motion", .feedthrough = false});
  is.output<&BoucWen::z, &BoucWen::z_>({.unit = "'A 'v s", .doc = "hysteretic variable"});
  is.state<&BoucWen::z_>({.unit = "'A 'v s", .doc = "hysteretic variable"});
}

}  // namespace stepwire
