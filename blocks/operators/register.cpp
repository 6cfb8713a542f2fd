#include "blocks/operators/register.hpp"

#include "blocks/operators/circle_plan.hpp"
#include "blocks/operators/drift_estimator.hpp"
#include "blocks/operators/ornstein_uhlenbeck.hpp"
#include "blocks/operators/resistance_search.hpp"

namespace stepwire {

void register_operators(Registry& registry) {
  registry.add<CirclePlan>("operators");
  registry.add<DriftEstimator>("operators");
  registry.add<OrnsteinUhlenbeck>("operators");
  registry.add<ResistanceSearch>("operators");
}

}  // namespace stepwire
