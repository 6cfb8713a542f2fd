#pragma once

#include <string>

#include "engine/base/yaml/error.hpp"

namespace stepwire::run {

/// What ends a run before its time.
struct RunFault {
  std::string block, port;
  double time = 0.0;  ///< [s]
  yaml::Fault fault;
};

/// What a block had to say during a run.
struct RaisedDiagnostic {
  std::string block, text;
  double time = 0.0;  ///< when first [s]
};

}  // namespace stepwire::run
