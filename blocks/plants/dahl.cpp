#include "blocks/plants/dahl.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Dahl::declare(Declare<Dahl>& is) {
  is.block("Dahl",
           {.doc = "Friction as a spring that yields, Dahl's model: dF/dx = stiffness (1 - sign(v) F / "
                   "coulomb)^shape; y = -F is "
                   "the force on the body. It depends on the way, not on the speed: from rest F = coulomb (1 "
                   "- exp(-stiffness x "
                   "/ coulomb)) with shape 1. A body at rest gives way a little and then holds. Friction "
                   "sticks without that, and "
                   "LuGre has breakaway and a fall with the speed.",
            .source = "P. R. Dahl 1968, A solid friction model, TOR-0158(3107-18)-1, Aerospace Corporation",
            .symbol = {.curve = "M-1 .7C-.4 .7 0 -.7 1 -.7M-1 .7C-.2 .7 .4 .5 1 -.7"},
            .smooth = true});
  is.parameter<&Dahl::stiffness>({.unit = "N/m", .doc = "where the force is 0", .above = 0.0});
  is.parameter<&Dahl::coulomb>({.unit = "N", .doc = "force of a long way", .above = 0.0});
  is.parameter<&Dahl::shape>(
      {.doc = "exponent: 1 for most materials, less where it yields at once", .at_least = 0.0});
  is.input<&Dahl::velocity>({.unit = "m/s", .doc = "of the body", .feedthrough = false});
  is.output<&Dahl::y>({.unit = "N", .doc = "force of the friction on the body"});
  is.state<&Dahl::force>({.unit = "N", .doc = "the same against the motion"});
}

}  // namespace stepwire
