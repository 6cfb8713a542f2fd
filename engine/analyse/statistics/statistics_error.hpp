#pragma once

#include <stdexcept>

namespace stepwire::statistics {

/// Numbers that a method cannot work on, and what it would need: "a circle needs three points, there are 2".
class StatisticsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stepwire::statistics
