#include "blocks/sources/chirp.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Chirp::configure(Configure& is) {
  configure_own_time(*this, is);
  if (sweep != Sweep::exponential) return;
  if (frequency <= 0.0)
    is.refuse<&Chirp::frequency>("an exponential sweep cannot begin at 0 Hz or below; give one above 0");
  if (target_frequency <= 0.0)
    is.refuse<&Chirp::target_frequency>("an exponential sweep cannot end at 0 Hz or below; give one above 0");
}

void Chirp::declare(Declare<Chirp>& is) {
  is.block(
      "Chirp",
      {.doc = "A sine of moving frequency: y = amplitude sin(2 pi cycles(t) + phase) + bias, where cycles "
              "is the integral of the frequency. From target_time on the frequency stays.",
       .symbol = {.curve =
                      "M-1 0C-.8 1.2 -.6 1.2 -.4 0C-.27 -1.2 -.13 -1.2 0 0C.1 1.2 .2 1.2 .3 0C.37 -1.2 .44 "
                      "-1.2 .5 0C.56 1.2 .62 1.2 .67 0C.72 -1.2 .77 -1.2 .82 0C.88 1.2 .94 1.2 1 0"},
       .at_events = true,
       .smooth = true});
  is.parameter<&Chirp::amplitude>({.unit = "delta 'u", .doc = "half of the distance between the peaks"});
  is.parameter<&Chirp::frequency>({.unit = "Hz", .doc = "frequency at t = 0", .at_least = 0.0});
  is.parameter<&Chirp::target_frequency>({.unit = "Hz", .doc = "frequency at target_time", .at_least = 0.0});
  is.parameter<&Chirp::target_time>({.unit = "s", .doc = "how long the frequency moves", .above = 0.0});
  is.parameter<&Chirp::phase>({.unit = "rad", .doc = "angle at t = 0"});
  is.parameter<&Chirp::bias>({.unit = "'u", .doc = "mean value"});
  is.parameter<&Chirp::sweep>(
      {.doc = "linear: the same number of hertz each second; exponential: the same number of "
              "octaves each second (both frequencies above 0)",
       .words = {"linear", "exponential"}});
  is.output<&Chirp::y>({.unit = "'u", .doc = "the sweep"});
  declare_own_time(is);
}

}  // namespace stepwire
