#include "blocks/math/register.hpp"

namespace stepwire {

void register_math(Registry&) {}

}  // namespace stepwire
