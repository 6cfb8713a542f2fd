#include "blocks/continuous/register.hpp"

#include "blocks/continuous/derivative.hpp"
#include "blocks/continuous/integrator.hpp"
#include "blocks/continuous/lag.hpp"
#include "blocks/continuous/luenberger_observer.hpp"
#include "blocks/continuous/pid.hpp"
#include "blocks/continuous/quaternion_integrator.hpp"
#include "blocks/continuous/state_space.hpp"
#include "blocks/continuous/transfer_function.hpp"
#include "blocks/continuous/transport_delay.hpp"

namespace stepwire {

void register_continuous(Registry& registry) {
  registry.add<Derivative>("continuous");
  registry.add<Integrator>("continuous");
  registry.add<Lag>("continuous");
  registry.add<PID>("continuous");
  registry.add<StateSpace>("continuous");
  registry.add<TransferFunction>("continuous");
  registry.add<TransportDelay>("continuous");
  registry.add<LuenbergerObserver>("continuous");
  registry.add<QuaternionIntegrator>("continuous");
}

}  // namespace stepwire
