#include "blocks/continuous/quaternion_integrator.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void QuaternionIntegrator::declare(Declare<QuaternionIntegrator>& is) {
  using Block = QuaternionIntegrator;
  is.block(
      "QuaternionIntegrator",
      {.doc = "Attitude q = [w, x, y, z] from an angular velocity: dq/dt = q w / 2 with the velocity in the "
              "turned frame (as a gyroscope measures it), or w q / 2 in the fixed one. Each tick its length "
              "is made 1 again. Left out, `initial` is [1, 0, 0, 0]: not turned.",
       .source = "e.g. Diebel, Representing Attitude, Stanford University, 2006",
       .symbol = {.text = "∫ ½ q ω"},
       .smooth = true});
  is.parameter<&Block::frame>({.doc = "in which the velocity is given", .words = {"turned", "fixed"}});
  is.input<&Block::rate>({.unit = "rad/s", .doc = "angular velocity", .feedthrough = false});
  is.output<&Block::y>({.doc = "the attitude, a quaternion of length 1"});
  is.state<&Block::x>({.doc = "the attitude; its length differs a little from 1 between ticks"});
  declare_reset(is, "1", "the attitude", "4");
}

void QuaternionIntegrator::configure(Configure& is) {
  configure_reset(*this, is);
}

}  // namespace stepwire
