#pragma once

#include <stdexcept>

namespace stepwire::fmi {

/// Thrown for a unit that cannot be read, loaded or started; the text is one sentence.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::fmi
