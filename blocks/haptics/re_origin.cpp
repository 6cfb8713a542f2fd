#include "blocks/haptics/re_origin.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void ReOrigin::declare(Declare<ReOrigin>& is) {
  is.block("ReOrigin",
           {.doc = "Moves a resistance map instead of the pin: where the pin is outside of the authorized "
                   "region, or less than margin inside, the origin of the map is moved, along the shortest "
                   "way, until the pin is margin inside. Without a trigger this happens once, at the first "
                   "tick; with one whenever it turns from 0 to another value. The Region is fed the shifted "
                   "position, and its outputs come back here; they count from the tick after. The region as "
                   "moved may lie outside of the workspace.",
            .source = "thesis 2.4.3, first approach"});
  is.parameter<&ReOrigin::margin>(
      {.unit = "m", .doc = "how far inside of the region the pin is put", .at_least = 0.0});
  is.input<&ReOrigin::position>({.unit = "m", .doc = "of the pin"});
  is.input<&ReOrigin::nearest>(
      {.unit = "m", .doc = "nearest boundary point, from the Region", .feedthrough = false});
  is.input<&ReOrigin::direction>({.doc = "outward direction there, from the Region", .feedthrough = false});
  is.input<&ReOrigin::distance>(
      {.unit = "m", .doc = "signed distance, from the Region", .feedthrough = false});
  is.input<&ReOrigin::trigger>(
      {.doc = "moves the map when it leaves 0", .feedthrough = false, .optional = true});
  is.output<&ReOrigin::shifted>({.unit = "m", .doc = "position in the map"});
  is.output<&ReOrigin::origin>({.unit = "m", .doc = "where the map's origin lies"});
  is.state<&ReOrigin::moved>({.unit = "m", .doc = "where the map's origin lies", .settable = false});
  is.state<&ReOrigin::before>({.doc = "whether the trigger was given at the last tick", .settable = false});
}

}  // namespace stepwire
