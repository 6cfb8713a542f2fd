#include "blocks/haptics/directionality.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Directionality::configure(Configure& is) {
  if (direction == Direction::motion) is.require<&Directionality::position>("direction is motion");
  if (is.connected<&Directionality::angle>()) is.size("n", 2);
}

void Directionality::declare(Declare<Directionality>& is) {
  is.block(
      "Directionality",
      {.doc = "Resistance directionality: the force of the device on the hand that is wanted, from the "
              "largest resistance F_max, a vector toward the authorized region, and the direction in which "
              "the hand pushes. D1 resists on each axis on which the hand pushes away from the region, with "
              "F_max of that axis: nothing where their product is positive or 0. Its axes are those of the "
              "vectors, in a plane turned by `angle`: with the angle of the position they are the radial and "
              "the tangential axis of a polar device. D2 resists against the push "
              "with |F_max| times a gain: 1 for a push away from the region, the sine of the angle between "
              "push and F_max for one toward it, so that only the straight way back is free; both are 1 at "
              "90 degrees. Where the hand does not push (not above threshold) or F_max is 0 both give 0: "
              "there is no direction in which to resist. The hand's force is partly made by the resistance "
              "itself, so that under a push at given speed its direction drifts; with `direction: motion` "
              "the displacement over the last `travel` stands in its place, 0 before the first motion.",
       .source = "thesis 3.4.2, eq. 11-16; direction: motion and the cases of 0 are assumptions"});
  is.parameter<&Directionality::law>({.doc = "which of the two laws", .words = {"D1", "D2"}});
  is.parameter<&Directionality::direction>(
      {.doc = "what tells where the hand wants to go", .words = {"force", "motion"}});
  is.parameter<&Directionality::threshold>(
      {.unit = "N",
       .doc = "force up to which the hand does not push (D1: on that axis), e.g. the noise of its sensor",
       .at_least = 0.0});
  is.parameter<&Directionality::travel>(
      {.unit = "m", .doc = "motion: displacement over which its direction is taken", .above = 0.0});
  is.input<&Directionality::f_max>(
      {.unit = "N", .doc = "largest resistance, a vector toward the authorized region"});
  is.input<&Directionality::force>(
      {.unit = "N", .doc = "measured force of the hand on the device; motion: not used"});
  is.input<&Directionality::position>({.unit = "m", .doc = "measured position", .optional = true});
  is.input<&Directionality::angle>({.unit = "rad",
                                    .doc = "D1, in a plane: by which its axes are turned from those of the "
                                           "vectors; left out: 0. D2 has no axes",
                                    .optional = true});
  is.output<&Directionality::y>({.unit = "N", .doc = "wanted force of the device on the hand"});
  is.output<&Directionality::gain>({.doc = "D1: 0 or 1 for each axis; D2: 0 to 1, the same for all"});
  is.state<&Directionality::behind>(
      {.unit = "m", .doc = "end of the displacement over travel", .settable = false});
  is.state<&Directionality::is_drawn>({.doc = "1 from the first tick on", .settable = false});
}

}  // namespace stepwire
