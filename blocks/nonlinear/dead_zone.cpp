#include "blocks/nonlinear/dead_zone.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void DeadZone::configure(Configure& is) {
  require_order<&DeadZone::lower, &DeadZone::upper>(*this, is);
}

void DeadZone::declare(Declare<DeadZone>& is) {
  is.block("DeadZone",
           {.doc = "Zero while lower <= u <= upper; u - upper above the zone, u - lower below it.",
            .symbol = {.curve = "M-1 -.9L-.4 0H.4L1 .9", .axes = true}});
  is.parameter<&DeadZone::lower>({.unit = "'u", .doc = "lower end of the zone"});
  is.parameter<&DeadZone::upper>({.unit = "'u", .doc = "upper end of the zone"});
  is.input<&DeadZone::u>({.unit = "'u", .doc = "signal"});
  is.output<&DeadZone::y>({.unit = "'u", .doc = "how far the signal lies outside of the zone, with sign"});
}

}  // namespace stepwire
