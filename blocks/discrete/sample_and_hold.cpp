#include "blocks/discrete/sample_and_hold.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void SampleAndHold::configure(Configure& is) {
  is.skip_before_instant(trigger != Trigger::level || !is.acts_at_events());
}

void SampleAndHold::declare(Declare<SampleAndHold>& is) {
  is.block(
      "SampleAndHold",
      {.doc = "Takes its input at the ticks at which `when` says so, shows it at once, and holds it until "
              "the next time; `initial` before the first. With the trigger `level` it follows its input "
              "while `when` is true, and holds the last value after that: the one of the last tick, and with "
              "`events: locate` the one just before `when` becomes false.",
       .symbol = {.curve = "M-1 -.8C-.6 -.8 -.6 .4 -.3 .4H.3M.3 .4H1M-.3 -.9V-.5M.3 -.9V-.5"},
       .at_events = true});
  is.parameter<&SampleAndHold::trigger>(
      {.doc = "when the input is taken: `when` becomes true (rising), false (falling), either, or is true "
              "(level). True is above 0; there is no edge at the first step",
       .words = {"rising", "falling", "either", "level"}});
  is.input<&SampleAndHold::u>({.unit = "'u", .doc = "signal to sample"});
  is.input<&SampleAndHold::when>({.unit = "*", .doc = "says when"});
  is.crossing<&SampleAndHold::when>("`when` becomes true or false", "1");
  is.output<&SampleAndHold::y>({.unit = "'u", .doc = "the last sample"});
  is.state<&SampleAndHold::last>({.unit = "'u", .doc = "the last sample"});
  is.state<&SampleAndHold::side>(
      {.doc = "`when` at the last tick: -1 false, 1 true, 0 none yet", .settable = false});
}

}  // namespace stepwire
