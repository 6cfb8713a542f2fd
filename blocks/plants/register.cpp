#include "blocks/plants/register.hpp"

namespace stepwire {

void register_plants(Registry&) {}

}  // namespace stepwire
