#include "engine/model/block/limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire {

std::string order_problem(const PerElement& lower, const PerElement& upper, std::string_view upper_name) {
  // A single number applies to all elements; the shape check refuses different lengths.
  const Index size = std::max(lower.size(), upper.size());
  for (Index i = 0; i < size; ++i) {
    const double low = lower[std::min(i, lower.size() - 1)], high = upper[std::min(i, upper.size() - 1)];
    if (low > high) return fmt::format("{} lies above {} {}; it must not", low, upper_name, high);
  }
  return "";
}

}  // namespace stepwire
