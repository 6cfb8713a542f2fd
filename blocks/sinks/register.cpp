#include "blocks/sinks/register.hpp"

#include "blocks/sinks/assert.hpp"
#include "blocks/sinks/terminator.hpp"

namespace stepwire {

void register_sinks(Registry& registry) {
  registry.add<Terminator>("sinks");
  registry.add<Assert>("sinks");
}

}  // namespace stepwire
