#include "blocks/haptics/force_feedback.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void ForceFeedback::declare(Declare<ForceFeedback>& is) {
  is.block(
      "ForceFeedback",
      {.doc = "Force feedback for joints that can only resist: the resistance to ask of a joint's damper is "
              "the wanted one, plus a proportional and an integral part of what the measured force lacks. "
              "Only where the wanted effort of the device opposes that of the hand; where it does not, or "
              "nothing is wanted, 0 is asked for and the integral starts anew. While the hand does not push "
              "(not above threshold) the wanted resistance is asked for as it is. Beyond [0, limit] the "
              "integral waits. Forces or torques, in units of their own.",
       .source = "thesis 3.4, figure 30; that the parts act on magnitudes is an assumption"});
  is.parameter<&ForceFeedback::kp>({.doc = "proportional gain", .at_least = 0.0});
  is.parameter<&ForceFeedback::ki>({.unit = "1/s", .doc = "integral gain", .at_least = 0.0});
  is.parameter<&ForceFeedback::integral_limit>(
      {.unit = "'u", .doc = "largest integral part either way; none where left out", .at_least = 0.0});
  is.parameter<&ForceFeedback::limit>(
      {.unit = "'u", .doc = "most that the damper can resist; none where left out", .at_least = 0.0});
  is.parameter<&ForceFeedback::threshold>(
      {.unit = "'u", .doc = "effort up to which the hand does not push, e.g. noise", .at_least = 0.0});
  is.input<&ForceFeedback::wanted>({.unit = "'u", .doc = "wanted effort of the device on the hand"});
  is.input<&ForceFeedback::measured>({.unit = "'u", .doc = "measured effort of the hand on the device"});
  is.output<&ForceFeedback::y>({.unit = "'u", .doc = "resistance to ask of the damper, never negative"});
  is.output<&ForceFeedback::realisable>(
      {.unit = "'u", .doc = "what of the wanted effort a damper within its limit can make"});
  is.state<&ForceFeedback::integral>({.unit = "'u", .doc = "integral part"});
  is.clock<&ForceFeedback::period>();
}

}  // namespace stepwire
