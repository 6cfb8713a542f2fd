#include "blocks/sources/sine.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Sine::configure(Configure& is) {
  configure_own_time(*this, is);
}

void Sine::declare(Declare<Sine>& is) {
  is.block("Sine", {.doc = "A sine wave: y = amplitude sin(2 pi frequency t + phase) + bias.",
                    .symbol = {.curve = "M-1 0C-.75 1.05 -.25 1.05 0 0C.25 -1.05 .75 -1.05 1 0"},
                    .at_events = true,
                    .smooth = true});
  is.parameter<&Sine::amplitude>({.unit = "delta 'u", .doc = "half of the distance between the peaks"});
  is.parameter<&Sine::frequency>({.unit = "Hz", .doc = "periods per second (not radians)"});
  is.parameter<&Sine::phase>({.unit = "rad", .doc = "angle at t = 0; a cosine has 90 deg"});
  is.parameter<&Sine::bias>({.unit = "'u", .doc = "mean value"});
  is.output<&Sine::y>({.unit = "'u", .doc = "the wave"});
  declare_own_time(is);
  is.prepared<&Sine::omega>();
}

}  // namespace stepwire
