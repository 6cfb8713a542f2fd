#pragma once

#include <string>

#include "engine/base/yaml/error.hpp"

namespace stepwire::run {

/// Fault that ends a run before its stop time.
struct RunFault {
  std::string block, port;
  double time = 0.0;  ///< [s]
  yaml::Fault fault;
};

/// Diagnostic that a block has raised during a run.
struct RaisedDiagnostic {
  std::string block, text;
  double time = 0.0;  ///< first time [s]
};

}  // namespace stepwire::run
