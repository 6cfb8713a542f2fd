#pragma once

#include <stdexcept>

namespace stepwire::fmi {

/// What is wrong with a unit, in one sentence: it cannot be read, loaded or started.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::fmi
