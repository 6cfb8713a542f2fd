#include "blocks/logic/register.hpp"

namespace stepwire {

void register_logic(Registry&) {}

}  // namespace stepwire
