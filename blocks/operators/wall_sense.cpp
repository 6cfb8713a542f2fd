#include "blocks/operators/wall_sense.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void WallSense::declare(Declare<WallSense>& is) {
  is.block(
      "WallSense",
      {.doc = "What a hand feels of the walls of a corridor that only resist, and so do not push it back to "
              "its middle: that it is outside, where more resists than a free motion meets, and on which "
              "side, by whether it moved outward as this began, if it has entered the wall then, and whether "
              "resistance rises with the way "
              "that it has gone outward since, or with that inward. `measured` is the distance from the "
              "middle that is expected "
              "from this, its precision counts the other side in. Inside of the corridor nothing is said.",
       .source = "Weber fraction of a force in active motion: 10.1109/TOH.2013.4; walls of thesis 3.4",
       .timing = Timing::discrete});
  is.parameter<&WallSense::weber>({.doc = "error of a felt force as a share of it", .at_least = 0.0});
  is.parameter<&WallSense::threshold>({.unit = "N", .doc = "error of a weak force", .at_least = 0.0});
  is.parameter<&WallSense::just>(
      {.doc = "by how many times its error a force stands out from what is known", .at_least = 0.0});
  is.parameter<&WallSense::wrong>(
      {.unit = "m/s", .doc = "deviation of the felt rate", .above = 0.0, .required = true});
  is.parameter<&WallSense::offset>({.unit = "N", .doc = "resistance on entering a wall, as learnt before"});
  is.parameter<&WallSense::slope>({.unit = "N/m",
                                   .doc = "its rise with the way outside, as learnt before",
                                   .above = 0.0,
                                   .required = true});
  is.parameter<&WallSense::half>({.unit = "m", .doc = "half the width of the corridor", .at_least = 0.0});
  is.parameter<&WallSense::entered>(
      {.doc = "probability that a wall that is felt was just entered, and is not felt again outside",
       .at_least = 0.0,
       .at_most = 1.0});
  is.input<&WallSense::resistance>({.unit = "N", .doc = "as felt, F"});
  is.input<&WallSense::free>({.unit = "N", .doc = "that a free motion meets, as learnt before, E"});
  is.input<&WallSense::rate>({.unit = "m/s", .doc = "at which the hand moves outward, as felt"});
  is.input<&WallSense::held>(
      {.doc = "1: the hand does not move, and feels no more than it pushes; left out: it moves",
       .optional = true});
  is.output<&WallSense::outside>({.doc = "1 where a wall is felt"});
  is.output<&WallSense::side>({.doc = "1: surely outward, -1: surely inward, 0: not known"});
  is.output<&WallSense::measured>({.unit = "m", .doc = "distance outward from the middle that is expected"});
  is.output<&WallSense::precision>({.unit = "1/m^2", .doc = "of that; 0: nothing is felt"});
  is.state<&WallSense::first>({.doc = "logarithm of the odds as it was felt first", .settable = false});
  is.state<&WallSense::way>(
      {.unit = "m", .doc = "way outward since it left the corridor", .settable = false});
  is.state<&WallSense::since>({.unit = "s", .doc = "time since then; 0: inside", .settable = false});
  is.clock<&WallSense::period>();
}

}  // namespace stepwire
