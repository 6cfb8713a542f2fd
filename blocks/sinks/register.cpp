#include "blocks/sinks/register.hpp"

namespace stepwire {

void register_sinks(Registry&) {}

}  // namespace stepwire
