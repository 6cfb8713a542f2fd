#include "blocks/sources/register.hpp"

namespace stepwire {

void register_sources(Registry&) {}

}  // namespace stepwire
