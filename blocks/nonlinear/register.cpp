#include "blocks/nonlinear/register.hpp"

namespace stepwire {

void register_nonlinear(Registry&) {}

}  // namespace stepwire
