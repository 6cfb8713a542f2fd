#include "blocks/routing/register.hpp"

#include "blocks/routing/demux.hpp"
#include "blocks/routing/mux.hpp"
#include "blocks/routing/select.hpp"

namespace stepwire {

void register_routing(Registry& registry) {
  registry.add<Mux>("routing");
  registry.add<Demux>("routing");
  registry.add<Select>("routing");
}

}  // namespace stepwire
