#include "blocks/sources/register.hpp"

#include "blocks/sources/chirp.hpp"
#include "blocks/sources/clock.hpp"
#include "blocks/sources/constant.hpp"
#include "blocks/sources/from_file.hpp"
#include "blocks/sources/multisine.hpp"
#include "blocks/sources/noise.hpp"
#include "blocks/sources/pulse.hpp"
#include "blocks/sources/ramp.hpp"
#include "blocks/sources/sine.hpp"
#include "blocks/sources/step.hpp"
#include "blocks/sources/straight_motion.hpp"

namespace stepwire {

void register_sources(Registry& registry) {
  registry.add<Constant>("sources");
  registry.add<Step>("sources");
  registry.add<StraightMotion>("sources");
  registry.add<Ramp>("sources");
  registry.add<Sine>("sources");
  registry.add<Chirp>("sources");
  registry.add<Multisine>("sources");
  registry.add<Noise>("sources");
  registry.add<Pulse>("sources");
  registry.add<Clock>("sources");
  registry.add<FromFile>("sources");
}

}  // namespace stepwire
