#include "blocks/hardware/register.hpp"

#include "blocks/hardware/amplifier.hpp"
#include "blocks/hardware/sensor.hpp"

namespace stepwire {

void register_hardware(Registry& registry) {
  registry.add<Amplifier>("hardware");
  registry.add<Sensor>("hardware");
}

}  // namespace stepwire
