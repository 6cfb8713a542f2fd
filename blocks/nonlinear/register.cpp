#include "blocks/nonlinear/register.hpp"

#include "blocks/nonlinear/backlash.hpp"
#include "blocks/nonlinear/coulomb.hpp"
#include "blocks/nonlinear/dead_zone.hpp"
#include "blocks/nonlinear/quantizer.hpp"
#include "blocks/nonlinear/rate_limiter.hpp"
#include "blocks/nonlinear/relay.hpp"
#include "blocks/nonlinear/saturation.hpp"

namespace stepwire {

void register_nonlinear(Registry& registry) {
  registry.add<Backlash>("nonlinear");
  registry.add<Coulomb>("nonlinear");
  registry.add<DeadZone>("nonlinear");
  registry.add<Quantizer>("nonlinear");
  registry.add<RateLimiter>("nonlinear");
  registry.add<Relay>("nonlinear");
  registry.add<Saturation>("nonlinear");
}

}  // namespace stepwire
