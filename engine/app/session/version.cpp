#include "engine/app/session/version.hpp"

namespace stepwire::session {

std::string program_version() {
  return STEPWIRE_VERSION;
}

std::string compiler_version() {
#ifdef __clang__
  const std::string name = "clang++ ";
#else
  const std::string name = "g++ ";
#endif
  return name + __VERSION__ + " " + STEPWIRE_FLAGS;
}

}  // namespace stepwire::session
