#pragma once

#include <cstddef>

namespace stepwire {

/// Counts elements; the same type as Eigen's.
using Index = std::ptrdiff_t;

/// A port or state whose size is known only when the diagram is planned.
inline constexpr int any_size = -1;

}  // namespace stepwire
