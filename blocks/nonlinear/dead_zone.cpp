#include "blocks/nonlinear/dead_zone.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void DeadZone::configure(Configure& is) {
  const bool wired = is.connected<&DeadZone::lower_>() || is.connected<&DeadZone::upper_>();
  if (!wired) require_order<&DeadZone::lower, &DeadZone::upper>(*this, is);
}

void DeadZone::declare(Declare<DeadZone>& is) {
  is.block(
      "DeadZone",
      {.doc = "Zero while lower <= u <= upper; u - upper above the zone, u - lower below it. An end of the "
              "zone is a number or a signal.",
       .symbol = {.curve = "M-1 -.9L-.4 0H.4L1 .9", .axes = true},
       .smooth = true});
  is.parameter<&DeadZone::lower>({.unit = "'u", .doc = "lower end of the zone"});
  is.parameter<&DeadZone::upper>({.unit = "'u", .doc = "upper end of the zone"});
  is.input<&DeadZone::u>({.unit = "'u", .doc = "signal"});
  is.input<&DeadZone::lower_>({.unit = "'u", .doc = "lower end as a signal", .optional = true});
  is.input<&DeadZone::upper_>({.unit = "'u", .doc = "upper end as a signal", .optional = true});
  is.crossing<&DeadZone::u, &DeadZone::lower_>("u reaches the lower end of the zone");
  is.crossing<&DeadZone::u, &DeadZone::upper_>("u reaches the upper end");
  is.output<&DeadZone::y>(
      {.unit = "delta 'u", .doc = "how far the signal lies outside of the zone, with sign"});
}

}  // namespace stepwire
