#include "blocks/hardware/encoder_to_angle.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void EncoderToAngle::declare(Declare<EncoderToAngle>& is) {
  is.block("EncoderToAngle",
           {.doc = "The angle of an encoder from the counts that a board delivers, continued over wraps of "
                   "the counter. From tick to tick the counts may change by less than half of the counter, "
                   "and by at most `largest_step`; a change above that, or counts that the counter does not "
                   "have, are a fault: the angle stays where it was, until the counts are again within that "
                   "of the last ones that were believed. The first counts are taken from 0 the shorter way.",
            .source = "thesis 3.2",
            .timing = Timing::discrete,
            .at_end = true});
  is.parameter<&EncoderToAngle::counts_per_revolution>(
      {.doc = "edges of both tracks, four for each line", .above = 0.0});
  is.parameter<&EncoderToAngle::zero>({.unit = "rad", .doc = "angle of count 0"});
  is.parameter<&EncoderToAngle::largest_step>(
      {.doc = "counts that a tick can bring at most; half of the counter where left out", .above = 0.0});
  is.parameter<&EncoderToAngle::bits>({.doc = "of the counter", .at_least = 2.0, .at_most = 48.0});
  is.input<&EncoderToAngle::counts>({.doc = "what the counter shows, 0 to 2^bits - 1"});
  is.output<&EncoderToAngle::angle>({.unit = "rad", .doc = "of the shaft, over any number of turns"});
  is.output<&EncoderToAngle::fault>({.doc = "1 while the counts are not believed, else 0"});
  is.state<&EncoderToAngle::last>({.doc = "counts that were believed last"});
  is.state<&EncoderToAngle::total>({.doc = "counts since count 0, over all wraps"});
  is.state<&EncoderToAngle::begun>({.doc = "1 from the first tick on", .settable = false});
  is.diagnostic<&EncoderToAngle::jumped>(
      {.doc = "the counts jump further than the encoder can turn in a tick"});
  is.clock<&EncoderToAngle::time>();
  is.preset<rig_encoder_reading>("thesis-3.2", "4000 counts per revolution, counter of 24 bits");
  is.prepared<&EncoderToAngle::turn>();
  is.prepared<&EncoderToAngle::levels>();
}

}  // namespace stepwire
