#include "blocks/sources/ramp.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Ramp::configure(Configure& is) {
  configure_own_time(*this, is);
}

void Ramp::declare(Declare<Ramp>& is) {
  is.block("Ramp", {.doc = "Grows steadily from one instant on: y = initial + slope max(0, t - start).",
                    .symbol = {.curve = "M-1 -.7H-.4L1 .8"},
                    .at_events = true,
                    .smooth = true});
  is.parameter<&Ramp::slope>({.unit = "'u/s", .doc = "growth per second; may be negative"});
  is.parameter<&Ramp::start_>({.unit = "s", .doc = "instant from which it grows"});
  is.parameter<&Ramp::initial>({.unit = "'u", .doc = "value until then"});
  is.output<&Ramp::y>({.unit = "'u", .doc = "the ramp"});
  declare_own_time(is);
}

}  // namespace stepwire
