#include "blocks/sinks/assert.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Assert::declare(Declare<Assert>& is) {
  is.block(
      "Assert",
      {.doc = "Ends the run when what it is fed is false, that is zero in any element. It looks at every "
              "step and at each located event, or at every tick of its period; feed it from Compare, Logic "
              "or Expression, and give "
              "it a name that says what must hold.",
       .at_events = true,
       .at_end = true});
  is.input<&Assert::u>({.doc = "condition: 0 is false, anything else true", .feedthrough = false});
  is.diagnostic<&Assert::failed>({.doc = "what is asserted does not hold", .ends_run = true});
  is.clock<&Assert::t>();
}

}  // namespace stepwire
