#include "blocks/hardware/quadrature_encoder.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void QuadratureEncoder::declare(Declare<QuadratureEncoder>& is) {
  is.block(
      "QuadratureEncoder",
      {.doc = "An incremental encoder with the counter that reads it, in counts as a board delivers them: 0 "
              "to 2^bits - 1, and beyond either end from the other one on. Counting begins at the angle "
              "`zero`, halfway between two edges of the encoder. EncoderToAngle is the way back.",
       .source = "thesis 3.2; 24 bits are those of the counters of a Sensoray 626",
       .timing = Timing::discrete});
  is.parameter<&QuadratureEncoder::counts_per_revolution>(
      {.doc = "edges of both tracks, four for each line", .above = 0.0});
  is.parameter<&QuadratureEncoder::zero>({.unit = "rad", .doc = "angle of count 0"});
  is.parameter<&QuadratureEncoder::bits>({.doc = "of the counter", .at_least = 2.0, .at_most = 48.0});
  is.input<&QuadratureEncoder::angle>({.unit = "rad", .doc = "of the shaft"});
  is.output<&QuadratureEncoder::counts>({.doc = "what the counter shows, a whole number"});
  is.preset<rig_encoder>("thesis-3.2", "4000 counts per revolution, counter of 24 bits");
  is.prepared<&QuadratureEncoder::turn>();
  is.prepared<&QuadratureEncoder::levels>();
}

}  // namespace stepwire
