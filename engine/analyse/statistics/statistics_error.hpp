#pragma once

#include <stdexcept>

namespace stepwire::statistics {

/// Error: numbers that a method cannot process; the text names its requirement: "a circle needs three points,
/// there are 2".
class StatisticsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::statistics
