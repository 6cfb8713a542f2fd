#include "blocks/haptics/passivity_observer.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void PassivityObserver::declare(Declare<PassivityObserver>& is) {
  is.block(
      "PassivityObserver",
      {.doc = "The energy account of a port: what force and velocity have supplied since the start, what of "
              "it is dissipated beside what is stored (wire `stored` where the device can tell), and whether "
              "the device gave out more than it may. `judge: net` asks whether more came out than went in; a "
              "device that has dissipated much may then give out as much before it is noticed. `judge: fall` "
              "asks whether what was dissipated ever falls again, and needs `stored`. `budget` is what "
              "measuring may be wrong by. `booked` is energy that is known to come from elsewhere: the work "
              "that a change of the current does on an MR damper (`switching_work`). Force and velocity are "
              "those along which energy goes in, of any number of axes, with torques and angular velocities "
              "alike. It integrates as the solver does, or sums what is sampled.",
       .source = "B. Hannaford and J.-H. Ryu, IEEE Trans. Robotics and Automation 18 (2002) 1",
       .at_end = true,
       .smooth = true});
  is.parameter<&PassivityObserver::judge>({.doc = "what must not be", .words = {"net", "fall"}});
  is.parameter<&PassivityObserver::budget>(
      {.unit = "J", .doc = "energy that may come out all the same", .at_least = 0.0});
  is.input<&PassivityObserver::force>({.unit = "'f", .doc = "on the device", .feedthrough = false});
  is.input<&PassivityObserver::velocity>(
      {.unit = "W/'f", .doc = "of the point where the force acts", .feedthrough = false});
  is.input<&PassivityObserver::stored>({.unit = "J", .doc = "energy in the device", .optional = true});
  is.input<&PassivityObserver::booked>(
      {.unit = "J", .doc = "energy that went in another way since the start", .optional = true});
  is.output<&PassivityObserver::supplied>({.unit = "J", .doc = "through the port since the start"});
  is.output<&PassivityObserver::dissipated>({.unit = "J", .doc = "supplied, booked, and not stored"});
  is.output<&PassivityObserver::least_gain>(
      {.unit = "J", .doc = "smallest change of it in any step so far; below 0 where it ever fell"});
  is.output<&PassivityObserver::broken>({.doc = "1 while more than the budget has come out, else 0"});
  is.state<&PassivityObserver::energy>({.unit = "J", .doc = "what is supplied"});
  is.state<&PassivityObserver::first_stored>({.unit = "J", .doc = "stored at the start", .settable = false});
  is.state<&PassivityObserver::before>(
      {.unit = "J", .doc = "dissipated at the last step", .settable = false});
  is.state<&PassivityObserver::highest>(
      {.unit = "J", .doc = "most that was dissipated so far", .settable = false});
  is.state<&PassivityObserver::least>({.unit = "J", .doc = "smallest change so far", .settable = false});
  is.state<&PassivityObserver::begun>({.doc = "1 from the first step on", .settable = false});
  is.diagnostic<&PassivityObserver::gave_out>({.doc = "more energy came out than may"});
  is.clock<&PassivityObserver::time>();
}

}  // namespace stepwire
