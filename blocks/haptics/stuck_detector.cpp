#include "blocks/haptics/stuck_detector.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void StuckDetector::declare(Declare<StuckDetector>& is) {
  is.block("StuckDetector",
           {.doc = "1 where a sensor is stuck: none of its numbers has changed for longer than `time` while, "
                   "all that time, something else says that it should (`moving` is true). What that is "
                   "depends on the sensor: another one that sees the same motion, a force above all "
                   "friction, or 1 for a sensor whose noise never rests, which is stale when it does.",
            .timing = Timing::discrete});
  is.parameter<&StuckDetector::time>(
      {.unit = "s", .doc = "for which nothing changes at most", .at_least = 0.0});
  is.parameter<&StuckDetector::tolerance>(
      {.unit = "delta 'u", .doc = "change that does not count as one; none where left out", .at_least = 0.0});
  is.input<&StuckDetector::u>({.unit = "'u", .doc = "what is read from the sensor"});
  is.input<&StuckDetector::moving>({.unit = "*", .doc = "true while it should change"});
  is.output<&StuckDetector::y>({.doc = "1 while it is stuck, else 0"});
  is.state<&StuckDetector::held>(
      {.unit = "'u", .doc = "reading that has not changed since", .settable = false});
  is.state<&StuckDetector::still>({.unit = "s", .doc = "for how long", .settable = false});
  is.clock<&StuckDetector::period>();
}

}  // namespace stepwire
