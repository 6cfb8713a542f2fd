#include "blocks/operators/circle_plan.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void CirclePlan::declare(Declare<CirclePlan>& is) {
  is.block(
      "CirclePlan",
      {.doc = "Next via point of a hand that draws a circle counterclockwise, as the step toward it for a "
              "Submovements block: speed interval farther along the circle than where the hand will be "
              "when the movements under way are done, and nearer to it by 1 - exp(-correction interval) of "
              "the radial error. `turned` counts the angle that it believes to have gone around the centre, "
              "more than a turn as well.",
       .source = "correction at the crossover frequency of manual control: McRuer and Jex 1967; staircase "
                 "of via points: Guigon et al. 2019, J Neurophysiol 121:715",
       .timing = Timing::discrete});
  is.parameter<&CirclePlan::radius>({.unit = "m", .doc = "of the circle", .above = 0.0, .required = true});
  is.parameter<&CirclePlan::correction>(
      {.unit = "1/s", .doc = "rate at which a radial error is taken off", .at_least = 0.0, .required = true});
  is.input<&CirclePlan::position>({.unit = "m", .doc = "where the hand is believed to be, x and y"});
  is.input<&CirclePlan::pending>({.unit = "m", .doc = "what the movements under way will add, x and y"});
  is.input<&CirclePlan::center>({.unit = "m", .doc = "of the circle, x and y"});
  is.input<&CirclePlan::speed>({.unit = "m/s", .doc = "along the circle, as meant now"});
  is.input<&CirclePlan::interval>({.unit = "s", .doc = "time between two via points"});
  is.output<&CirclePlan::step>({.unit = "m", .doc = "to the next via point"});
  is.output<&CirclePlan::righting>({.unit = "m", .doc = "the part of it that takes off the radial error"});
  is.output<&CirclePlan::outward>({.doc = "unit vector from the centre to the believed position"});
  is.output<&CirclePlan::turned>({.unit = "rad", .doc = "angle gone around the centre so far"});
  is.output<&CirclePlan::off>({.unit = "m", .doc = "believed distance from the circle, positive outside"});
  is.state<&CirclePlan::facing>({.doc = "outward at the last tick", .settable = false});
  is.state<&CirclePlan::angle>({.unit = "rad", .doc = "angle gone until then", .settable = false});
}

}  // namespace stepwire
