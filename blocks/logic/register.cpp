#include "blocks/logic/register.hpp"

#include "blocks/logic/compare.hpp"
#include "blocks/logic/counter.hpp"
#include "blocks/logic/edge_detect.hpp"
#include "blocks/logic/hysteresis.hpp"
#include "blocks/logic/latch.hpp"
#include "blocks/logic/logic.hpp"
#include "blocks/logic/state_machine.hpp"
#include "blocks/logic/switch.hpp"

namespace stepwire {

void register_logic(Registry& registry) {
  registry.add<Compare>("logic");
  registry.add<EdgeDetect>("logic");
  registry.add<Hysteresis>("logic");
  registry.add<Latch>("logic");
  registry.add<Logic>("logic");
  registry.add<StateMachine>("logic");
  registry.add<Switch>("logic");
  registry.add<Counter>("logic");
}

}  // namespace stepwire
