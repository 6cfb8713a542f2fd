#pragma once

#include <stdexcept>
#include <string>

namespace stepwire::control {

/// Thrown for unusable matrices of a design: sizes that do not fit, a singular matrix, or no solution.
class ControlFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::control
