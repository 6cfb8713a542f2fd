#include "blocks/operators/register.hpp"

#include "blocks/operators/circle_plan.hpp"
#include "blocks/operators/direction_average.hpp"
#include "blocks/operators/drift_estimator.hpp"
#include "blocks/operators/forward_model.hpp"
#include "blocks/operators/heading_posterior.hpp"
#include "blocks/operators/load_adaptation.hpp"
#include "blocks/operators/path_drift.hpp"
#include "blocks/operators/position_estimate.hpp"
#include "blocks/operators/submovements.hpp"
#include "blocks/operators/wall_sense.hpp"

namespace stepwire {

void register_operators(Registry& registry) {
  registry.add<CirclePlan>("operators");
  registry.add<DirectionAverage>("operators");
  registry.add<DriftEstimator>("operators");
  registry.add<ForwardModel>("operators");
  registry.add<HeadingPosterior>("operators");
  registry.add<LoadAdaptation>("operators");
  registry.add<PathDrift>("operators");
  registry.add<PositionEstimate>("operators");
  registry.add<Submovements>("operators");
  registry.add<WallSense>("operators");
}

}  // namespace stepwire
