#pragma once

#include <limits>

namespace stepwire::statistics {

/// Missing value: NaN.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace stepwire::statistics
