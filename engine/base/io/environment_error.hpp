#pragma once

#include <stdexcept>
#include <string>

namespace stepwire::io {

/// Something outside of the diagram is missing or refuses: a full disk, no gnuplot, no data folder, no
/// permission.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::io
