#pragma once

#include <limits>

namespace stepwire::statistics {

/// What stands in the place of a number that does not exist.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace stepwire::statistics
