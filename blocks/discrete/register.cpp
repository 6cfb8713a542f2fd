#include "blocks/discrete/register.hpp"

namespace stepwire {

void register_discrete(Registry&) {}

}  // namespace stepwire
