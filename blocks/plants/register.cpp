#include "blocks/plants/register.hpp"

#include "blocks/plants/bouc_wen.hpp"
#include "blocks/plants/dahl.hpp"
#include "blocks/plants/driven_linkage.hpp"
#include "blocks/plants/friction.hpp"
#include "blocks/plants/hard_stop.hpp"
#include "blocks/plants/karnopp.hpp"
#include "blocks/plants/linkage.hpp"
#include "blocks/plants/lu_gre.hpp"
#include "blocks/plants/mass.hpp"
#include "blocks/plants/mr_damper.hpp"
#include "blocks/plants/pusher.hpp"
#include "blocks/plants/rotary_mr_damper.hpp"

namespace stepwire {

void register_plants(Registry& registry) {
  registry.add<BoucWen>("plants");
  registry.add<DrivenLinkage>("plants");
  registry.add<Linkage>("plants");
  registry.add<MRDamper>("plants");
  registry.add<Dahl>("plants");
  registry.add<Friction>("plants");
  registry.add<HardStop>("plants");
  registry.add<Karnopp>("plants");
  registry.add<LuGre>("plants");
  registry.add<Mass>("plants");
  registry.add<Pusher>("plants");
  registry.add<RotaryMRDamper>("plants");
}

}  // namespace stepwire
