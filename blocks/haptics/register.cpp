#include "blocks/haptics/register.hpp"

#include "blocks/haptics/directionality.hpp"
#include "blocks/haptics/force_feedback.hpp"
#include "blocks/haptics/guide_path.hpp"
#include "blocks/haptics/interlock.hpp"
#include "blocks/haptics/interval.hpp"
#include "blocks/haptics/layer_activator.hpp"
#include "blocks/haptics/passivity_observer.hpp"
#include "blocks/haptics/proportionality.hpp"
#include "blocks/haptics/re_origin.hpp"
#include "blocks/haptics/region.hpp"
#include "blocks/haptics/stuck_detector.hpp"

namespace stepwire {

void register_haptics(Registry& registry) {
  registry.add<Directionality>("haptics");
  registry.add<ForceFeedback>("haptics");
  registry.add<GuidePath>("haptics");
  registry.add<Interlock>("haptics");
  registry.add<Interval>("haptics");
  registry.add<LayerActivator>("haptics");
  registry.add<PassivityObserver>("haptics");
  registry.add<Proportionality>("haptics");
  registry.add<ReOrigin>("haptics");
  registry.add<Region>("haptics");
  registry.add<StuckDetector>("haptics");
}

}  // namespace stepwire
