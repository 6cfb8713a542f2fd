#include "engine/simulate/realtime/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::realtime {

std::int64_t Histogram::begin_of(std::size_t bin) {
  const std::size_t shift = bin < (2u << precision) ? 0 : (bin >> precision) - 1;
  return static_cast<std::int64_t>(bin - (shift << precision)) << shift;
}

std::int64_t Histogram::quantile(double fraction) const {
  if (count_ == 0) return 0;
  const auto wanted = static_cast<std::int64_t>(std::ceil(fraction * static_cast<double>(count_.get())));
  std::int64_t seen = 0;
  for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
    seen += counts_[bin];
    if (seen >= std::max<std::int64_t>(1, wanted)) return std::min(max_.get(), begin_of(bin + 1) - 1);
  }
  return max_;
}

}  // namespace stepwire::realtime
