#include "blocks/discrete/register.hpp"

#include "blocks/discrete/delay.hpp"
#include "blocks/discrete/discrete_integrator.hpp"
#include "blocks/discrete/discrete_luenberger_observer.hpp"
#include "blocks/discrete/discrete_pid.hpp"
#include "blocks/discrete/discrete_state_space.hpp"
#include "blocks/discrete/discrete_transfer_function.hpp"
#include "blocks/discrete/kalman_filter.hpp"
#include "blocks/discrete/moving_average.hpp"
#include "blocks/discrete/sample_and_hold.hpp"
#include "blocks/discrete/savitzky_golay.hpp"
#include "blocks/discrete/unit_delay.hpp"
#include "blocks/discrete/variable_delay.hpp"
#include "blocks/discrete/zero_order_hold.hpp"

namespace stepwire {

void register_discrete(Registry& registry) {
  registry.add<Delay>("discrete");
  registry.add<DiscreteIntegrator>("discrete");
  registry.add<DiscretePID>("discrete");
  registry.add<DiscreteTransferFunction>("discrete");
  registry.add<MovingAverage>("discrete");
  registry.add<SavitzkyGolay>("discrete");
  registry.add<UnitDelay>("discrete");
  registry.add<VariableDelay>("discrete");
  registry.add<ZeroOrderHold>("discrete");
  registry.add<DiscreteStateSpace>("discrete");
  registry.add<KalmanFilter>("discrete");
  registry.add<DiscreteLuenbergerObserver>("discrete");
  registry.add<SampleAndHold>("discrete");
}

}  // namespace stepwire
