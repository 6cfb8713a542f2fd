#include "blocks/hardware/register.hpp"

#include "blocks/hardware/amplifier.hpp"
#include "blocks/hardware/analog_to_digital.hpp"
#include "blocks/hardware/digital_to_analog.hpp"
#include "blocks/hardware/encoder_to_angle.hpp"
#include "blocks/hardware/load_cell.hpp"
#include "blocks/hardware/load_cell_to_wrench.hpp"
#include "blocks/hardware/quadrature_encoder.hpp"
#include "blocks/hardware/sensor.hpp"

namespace stepwire {

void register_hardware(Registry& registry) {
  registry.add<Amplifier>("hardware");
  registry.add<AnalogToDigital>("hardware");
  registry.add<DigitalToAnalog>("hardware");
  registry.add<EncoderToAngle>("hardware");
  registry.add<LoadCell>("hardware");
  registry.add<LoadCellToWrench>("hardware");
  registry.add<QuadratureEncoder>("hardware");
  registry.add<Sensor>("hardware");
}

}  // namespace stepwire
