#include "blocks/hardware/digital_to_analog.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void DigitalToAnalog::declare(Declare<DigitalToAnalog>& is) {
  is.block("DigitalToAnalog",
           {.doc = "A converter of an acquisition board, counts to volts: 2^bits levels over -range to "
                   "range; what is no level becomes the nearest one. In a controller the same block tells "
                   "the voltage that AnalogToDigital has counted.",
            .source = "thesis 3.2; datasheet of the Sensoray 626",
            .timing = Timing::discrete});
  is.parameter<&DigitalToAnalog::range>({.unit = "V", .doc = "from -range to range", .above = 0.0});
  is.parameter<&DigitalToAnalog::bits>({.doc = "of the converter", .at_least = 2.0, .at_most = 32.0});
  is.input<&DigitalToAnalog::counts>({.doc = "-2^(bits - 1) to 2^(bits - 1) - 1"});
  is.output<&DigitalToAnalog::y>({.unit = "V", .doc = "voltage"});
  is.preset<sensoray_626>("sensoray-626", "14 bits over -10 to 10 V");
  is.prepared<&DigitalToAnalog::most>();
}

}  // namespace stepwire
