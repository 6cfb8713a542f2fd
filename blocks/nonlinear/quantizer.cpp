#include "blocks/nonlinear/quantizer.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Quantizer::declare(Declare<Quantizer>& is) {
  is.block("Quantizer",
           {.doc = "The nearest multiple of the interval: y = interval floor(u / interval + 1/2). Halfway it "
                   "goes up, towards plus infinity: 0.5 to 1 and -0.5 to 0. With `events: locate` each step "
                   "of a signal without `every` is an event; for an interval so small that a signal passes "
                   "many within a step, as that of a sensor, give it `every`.",
            .symbol = {.curve = "M-1 -.9H-.75V-.45H-.25V0H.25V.45H.75V.9H1", .axes = true},
            .steady = true});
  is.parameter<&Quantizer::interval>({.unit = "delta 'u", .doc = "distance of two levels", .above = 0.0});
  is.input<&Quantizer::u>({.unit = "'u", .doc = "signal"});
  is.crossing<&Quantizer::u>("u is halfway between two levels");
  is.output<&Quantizer::y>({.unit = "'u", .doc = "the signal in whole intervals"});
}

}  // namespace stepwire
