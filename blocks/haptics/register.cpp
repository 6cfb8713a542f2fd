#include "blocks/haptics/register.hpp"

namespace stepwire {

void register_haptics(Registry&) {}

}  // namespace stepwire
