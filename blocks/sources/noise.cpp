#include "blocks/sources/noise.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Noise::configure(Configure& is) {
  if (!all_are(power, 0.0) && !all_are(deviation, 1.0))
    is.refuse<&Noise::power>("power and deviation both say how strong the noise is; give one of them");
}

void Noise::declare(Declare<Noise>& is) {
  is.block(
      "Noise",
      {.doc = "White noise, held from tick to tick: one independent sample per tick and element, "
              "y = mean + deviation w, where w has mean 0 and variance 1. Without `every` a tick is a step "
              "of the "
              "run. The same seed gives the same samples on every machine; two blocks with one seed give the "
              "same.",
       .source =
           "SplitMix64 on the number of the sample (Steele, Lea, Flood 2014); normal samples by inversion "
           "(Wichura 1988, AS 241)",
       .timing = Timing::discrete,
       .symbol = {.curve = "M-1 -.2L-.85 .5L-.7 -.7L-.55 .1L-.4 -.4L-.25 .9L-.1 -.1L.05 .4L.2 -.9L.35 .6L.5 "
                           "-.3L.65 .2L.8 -.6L1 .3"}});
  is.parameter<&Noise::seed>({.doc = "which sequence; a whole number", .required = true});
  is.parameter<&Noise::distribution>(
      {.doc = "of a sample: normal, or uniform within mean +- sqrt(3) deviation",
       .words = {"normal", "uniform"}});
  is.parameter<&Noise::mean>({.unit = "'u", .doc = "mean of a sample"});
  is.parameter<&Noise::deviation>(
      {.unit = "delta 'u", .doc = "standard deviation of a sample", .at_least = 0.0});
  is.parameter<&Noise::power>(
      {.unit = "'u^2 s",
       .doc = "two-sided spectral density well below the tick frequency, in place of deviation: "
              "a sample's deviation is then sqrt(power / period); 0: deviation holds",
       .at_least = 0.0});
  is.output<&Noise::y>({.unit = "'u", .doc = "the noise"});
  is.state<&Noise::sample>({.doc = "number of the sample", .settable = false});
  is.clock<&Noise::period>();
  is.prepared<&Noise::spread>();
}

}  // namespace stepwire
