#include "blocks/hardware/analog_to_digital.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void AnalogToDigital::declare(Declare<AnalogToDigital>& is) {
  is.block(
      "AnalogToDigital",
      {.doc =
           "A converter of an acquisition board, volts to counts: the nearest of 2^bits levels over -range "
           "to range, and the last one beyond either end. It samples at its ticks (`every`). In a controller "
           "the same block turns a wanted voltage into counts for DigitalToAnalog, which is the way back.",
       .source = "thesis 3.2; datasheet of the Sensoray 626",
       .timing = Timing::discrete,
       .at_end = true});
  is.parameter<&AnalogToDigital::range>({.unit = "V", .doc = "from -range to range", .above = 0.0});
  is.parameter<&AnalogToDigital::bits>({.doc = "of the converter", .at_least = 2.0, .at_most = 32.0});
  is.input<&AnalogToDigital::u>({.unit = "V", .doc = "voltage"});
  is.output<&AnalogToDigital::counts>({.doc = "a whole number, -2^(bits - 1) to 2^(bits - 1) - 1"});
  is.diagnostic<&AnalogToDigital::out_of_range>({.doc = "a voltage leaves the range; it counts as its end"});
  is.clock<&AnalogToDigital::time>();
  is.preset<sensoray_626>("sensoray-626", "14 bits over -10 to 10 V");
  is.prepared<&AnalogToDigital::most>();
}

}  // namespace stepwire
