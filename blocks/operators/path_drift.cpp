#include "blocks/operators/path_drift.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void PathDrift::configure(Configure& is) {
  is.size("n", place.size());
}

void PathDrift::declare(Declare<PathDrift>& is) {
  is.block(
      "PathDrift",
      {.doc = "Drift of the sense of where an unseen hand is. It grows by the way that the hand goes and not "
              "by the time, and toward a place that is the person's own: d(drift)/ds = (place - drift)/path. "
              "At rest nothing drifts, and twice the speed drifts as far on the same way. `initial` is what "
              "there is of it at the start.",
       .source = "of movement and not of time: Brown, Rosenbaum and Sainburg 2003, Exp Brain Res 153:266; to "
                 "the same place every time: Smeets et al. 2006, PNAS 103:18781; 5 cm over 44 cycles of 15 "
                 "cm: PMC5607024",
       .timing = Timing::discrete});
  is.parameter<&PathDrift::place>(
      {.unit = "m", .shape = "n", .doc = "to which it drifts, one for each axis"});
  is.parameter<&PathDrift::path>({.unit = "m",
                                  .doc = "way after which 1/e of the distance to that place is left",
                                  .above = 0.0,
                                  .required = true});
  is.input<&PathDrift::position>({.unit = "m", .shape = "n", .doc = "of the hand", .feedthrough = false});
  is.output<&PathDrift::y>({.unit = "m", .shape = "n", .doc = "the drift"});
  is.state<&PathDrift::drift>({.unit = "m", .shape = "n", .doc = "the drift"});
  is.state<&PathDrift::last>(
      {.unit = "m", .shape = "n", .doc = "position at the last tick", .settable = false});
  is.state<&PathDrift::begun>({.doc = "1 after the first tick", .settable = false});
}

}  // namespace stepwire
