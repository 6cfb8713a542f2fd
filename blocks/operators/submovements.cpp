#include "blocks/operators/submovements.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Submovements::declare(Declare<Submovements>& is) {
  is.block(
      "Submovements",
      {.doc =
           "Movement of a hand as people make slow ones, of pieces of constant duration: every `interval` "
           "a piece begins that goes to the next via point in minimum jerk, 10 s^3 - 15 s^4 + 6 s^5 over "
           "the duration overlap interval, and adds to the one still under way. A via point is the last "
           "one plus `step`, but never farther from the hand than `reach`, and a hand that is held is led "
           "on anew from where it is within the time `hold`, so that nothing winds up; but a `correction` of "
           "an error that is still there is kept, so that a push against what does not give way grows. What "
           "lies beyond `reach`, as it does where a resistance vanishes, is let go within a `reflex`. Speed "
           "changes the "
           "length of the pieces, not their duration. The outputs do "
           "not depend on the inputs at the same instant.",
       .source = "minimum jerk: Flash and Hogan 1985; staircase of goals: Guigon et al. 2019, J Neurophysiol "
                 "121:715; intervals of 260 to 310 ms: Loram et al. 2012, PMC3405763",
       .timing = Timing::discrete});
  is.parameter<&Submovements::interval>(
      {.unit = "s", .doc = "time between two via points", .above = 0.0, .required = true});
  is.parameter<&Submovements::overlap>(
      {.doc = "duration of a piece over the interval", .at_least = 1.0, .at_most = 2.0});
  is.parameter<&Submovements::latency>({.unit = "s", .doc = "time before the first piece", .at_least = 0.0});
  is.parameter<&Submovements::hold>(
      {.unit = "s", .doc = "in which it gives up that the hand is behind; left out: never", .above = 0.0});
  is.parameter<&Submovements::reflex>(
      {.unit = "s",
       .doc = "in which a hand that is led beyond reach is let go; left out: never",
       .above = 0.0});
  is.input<&Submovements::step>(
      {.unit = "m", .doc = "from the last via point to the next", .feedthrough = false});
  is.input<&Submovements::position>(
      {.unit = "m", .doc = "of the hand, as its joints feel it", .feedthrough = false});
  is.input<&Submovements::correction>(
      {.unit = "m",
       .doc = "the part of the step by which an error is corrected; left out: none",
       .feedthrough = false,
       .optional = true});
  is.input<&Submovements::reach>({.unit = "m",
                                  .doc = "how far ahead of the hand a via point may lie; left out: any",
                                  .feedthrough = false,
                                  .optional = true});
  is.output<&Submovements::equilibrium>({.unit = "m", .doc = "where the hand is meant to be by now"});
  is.output<&Submovements::velocity>({.unit = "m/s", .doc = "with which this moves"});
  is.output<&Submovements::pending>({.unit = "m", .doc = "what the pieces under way will still add"});
  is.output<&Submovements::begins>({.doc = "1 at the ticks at which a piece begins"});
  is.state<&Submovements::goal>({.unit = "m", .doc = "the last via point"});
  is.state<&Submovements::newer>({.unit = "m", .doc = "the last piece", .settable = false});
  is.state<&Submovements::older>({.unit = "m", .doc = "the one before", .settable = false});
  is.state<&Submovements::age>({.unit = "s", .doc = "since the last piece began", .settable = false});
  is.state<&Submovements::older_age>({.unit = "s", .doc = "since the one before", .settable = false});
  is.state<&Submovements::waited>({.unit = "s", .doc = "since the start", .settable = false});
  is.state<&Submovements::started>({.doc = "1 after the first piece began", .settable = false});
  is.clock<&Submovements::period>();
}

}  // namespace stepwire
