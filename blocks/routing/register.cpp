#include "blocks/routing/register.hpp"

namespace stepwire {

void register_routing(Registry&) {}

}  // namespace stepwire
