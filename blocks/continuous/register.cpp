#include "blocks/continuous/register.hpp"

#include "blocks/continuous/lag.hpp"

namespace stepwire {

void register_continuous(Registry& registry) {
  registry.add<Lag>("continuous");
}

}  // namespace stepwire
