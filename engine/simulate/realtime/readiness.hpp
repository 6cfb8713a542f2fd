#pragma once

#include <string>
#include <vector>

namespace stepwire::realtime {

/// One property of a machine that affects its deadlines.
struct Readiness {
  std::string what, found, cure;
  bool fits = false;
};

/// Returns the properties of this machine and of this process's permissions.
std::vector<Readiness> readiness();

}  // namespace stepwire::realtime
