#include "engine/analyse/claim/claim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::claim {

double Comparison::margin(double value) const {
  if (std::isnan(value)) return -std::numeric_limits<double>::infinity();
  switch (kind) {
    case Kind::at_most:
      return low - value;
    case Kind::at_least:
      return value - low;
    case Kind::between:
      return std::min(value - low, high - value);
    case Kind::equals:
      break;
  }
  // The difference of equal infinities is nan; it counts as 0.
  return value == low ? within : within - std::abs(value - low);
}

std::string Verdict::word() const {
  if (disagrees.empty()) return holds ? "holds" : "does not hold";
  return holds ? "holds after all" : "does not hold (known)";
}

}  // namespace stepwire::claim
