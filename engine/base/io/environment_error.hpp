#pragma once

#include <stdexcept>
#include <string>

namespace stepwire::io {

/// Thrown for a failure outside of the diagram: a full disk, no gnuplot, no data folder, no permission.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::io
