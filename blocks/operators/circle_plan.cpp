#include "blocks/operators/circle_plan.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void CirclePlan::declare(Declare<CirclePlan>& is) {
  is.block(
      "CirclePlan",
      {.doc = "Plan of a hand that draws a circle counterclockwise: the velocity that is meant next, at "
              "constant speed along the circle about `center`, and toward it at a rate proportional to the "
              "radial error of where the hand is believed to be, so that errors fall by 1/e in "
              "1/correction. `turned` counts the angle that it believes to have gone around the centre, "
              "more than a turn as well.",
       .source = "correction at the crossover frequency of manual control: McRuer and Jex 1967",
       .timing = Timing::discrete});
  is.parameter<&CirclePlan::radius>({.unit = "m", .doc = "of the circle", .above = 0.0, .required = true});
  is.parameter<&CirclePlan::speed>(
      {.unit = "m/s", .doc = "along the circle", .at_least = 0.0, .required = true});
  is.parameter<&CirclePlan::correction>(
      {.unit = "1/s", .doc = "radial speed per radial error", .at_least = 0.0, .required = true});
  is.input<&CirclePlan::position>({.unit = "m", .doc = "where the hand is believed to be, x and y"});
  is.input<&CirclePlan::center>({.unit = "m", .doc = "of the circle, x and y"});
  is.input<&CirclePlan::pace>(
      {.doc = "share of the speed that is meant now, not below 0; left out: 1", .optional = true});
  is.output<&CirclePlan::velocity>({.unit = "m/s", .doc = "that is meant"});
  is.output<&CirclePlan::outward>({.doc = "unit vector from the centre to the believed position"});
  is.output<&CirclePlan::turned>({.unit = "rad", .doc = "angle gone around the centre so far"});
  is.state<&CirclePlan::facing>({.doc = "outward at the last tick", .settable = false});
  is.state<&CirclePlan::angle>({.unit = "rad", .doc = "angle gone until then", .settable = false});
}

}  // namespace stepwire
