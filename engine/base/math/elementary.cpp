#include "engine/base/math/elementary.hpp"

namespace stepwire::fn {

constinit thread_local bool is_libm = false;

}  // namespace stepwire::fn
