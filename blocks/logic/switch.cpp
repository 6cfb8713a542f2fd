#include "blocks/logic/switch.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Switch::declare(Declare<Switch>& is) {
  is.block(
      "Switch",
      {.doc = "Passes `then` on where control > threshold (or as `criterion` says), `else` where not. Both "
              "inputs are computed all the time; the other one is not used.",
       .symbol = {.curve = "M-1 .7H-.5M-1 -.7H-.5M-.5 .7L.5 0H1"}});
  is.parameter<&Switch::threshold>({.unit = "'c", .doc = "what control is compared to"});
  is.parameter<&Switch::criterion>({.doc = "relation of control to the threshold that passes `then` on",
                                    .words = {"greater", "greater_equal", "not_equal"}});
  is.input<&Switch::control>({.unit = "'c", .doc = "decides"});
  is.input<&Switch::then>({.unit = "'u", .doc = "passed on where the criterion holds"});
  is.input<&Switch::else_>({.unit = "'u", .doc = "passed on where it does not"});
  is.crossing<&Switch::control>("the control passes its threshold", "1");
  is.output<&Switch::y>({.unit = "'u", .doc = "one of the two"});
  is.state<&Switch::branch>({.doc = "1 where `then` is passed on", .settable = false, .mode = true});
  is.derived<&Switch::holds_branch>();
}

void Switch::configure(Configure& is) {
  is.hold_mode(holds_branch);
}

}  // namespace stepwire
