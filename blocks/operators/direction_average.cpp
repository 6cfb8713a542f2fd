#include "blocks/operators/direction_average.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void DirectionAverage::declare(Declare<DirectionAverage>& is) {
  is.block(
      "DirectionAverage",
      {.doc = "What many looks at a direction say together. Each has an error of its own, of the deviation "
              "`noise`, which averages out, and one that is the same in all, of the deviation `bias`, which "
              "does not: the precision of the mean is never more than 1/bias^2. Earlier looks count less by "
              "1 - forgetting. Without a look the precision is 0.",
       .source = "that systematic errors dominate judgements of a direction: van Doorn, Koenderink and "
                 "Wagemans, ECVP",
       .timing = Timing::discrete});
  is.parameter<&DirectionAverage::noise>(
      {.unit = "rad", .doc = "deviation of a look alone", .above = 0.0, .required = true});
  is.parameter<&DirectionAverage::bias>(
      {.unit = "rad", .doc = "deviation of what all share", .at_least = 0.0});
  is.parameter<&DirectionAverage::forgetting>(
      {.doc = "share of what was seen that a look takes away", .at_least = 0.0, .at_most = 1.0});
  is.input<&DirectionAverage::direction>({.unit = "rad", .doc = "as judged at this tick"});
  is.input<&DirectionAverage::shown>(
      {.doc = "true where there is something to see; left out: always", .optional = true});
  is.output<&DirectionAverage::y>({.unit = "rad", .doc = "mean direction"});
  is.output<&DirectionAverage::precision>({.unit = "1/rad^2", .doc = "of the mean; 0: nothing was seen"});
  is.state<&DirectionAverage::sum>({.doc = "sum of unit vectors", .settable = false});
  is.state<&DirectionAverage::weight>({.doc = "looks that count", .settable = false});
  is.state<&DirectionAverage::squares>({.doc = "sum of the squares of their weights", .settable = false});
}

}  // namespace stepwire
