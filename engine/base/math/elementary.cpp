#include "engine/base/math/elementary.hpp"

namespace stepwire {

constinit thread_local bool fn::is_libm = false;

}  // namespace stepwire
