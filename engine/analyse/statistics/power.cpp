#include "engine/analyse/statistics/power.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/noncentral.hpp"
#include "engine/analyse/statistics/student.hpp"

namespace stepwire::statistics {

double paired_power(double d_z, std::size_t subjects) {
  if (std::isnan(d_z)) return d_z;
  const auto count = static_cast<double>(subjects);
  const double critical = student_quantile(0.975, count - 1.0), noncentrality = std::sqrt(count) * d_z;
  const double power = noncentral_student_tail(critical, count - 1.0, noncentrality) +
                       noncentral_student_tail(critical, count - 1.0, -noncentrality);
  return std::clamp(power, 0.0, 1.0);
}

std::optional<std::size_t> subjects_needed(double d_z, double power, std::size_t most) {
  if (!(paired_power(d_z, most) >= power)) return std::nullopt;
  std::size_t few = 1, enough = 2;
  for (; enough < most && paired_power(d_z, enough) < power; enough = std::min(most, 2 * enough))
    few = enough;
  while (enough - few > 1) {
    const std::size_t middle = few + (enough - few) / 2;
    (paired_power(d_z, middle) < power ? few : enough) = middle;
  }
  return enough;
}

}  // namespace stepwire::statistics
