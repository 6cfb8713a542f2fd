#include "engine/simulate/realtime/measurements.hpp"

#include <sys/resource.h>

#include <cmath>

#include "engine/simulate/realtime/allocations.hpp"

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

ThreadCounts ThreadCounts::now() {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return {usage.ru_minflt, usage.ru_majflt, usage.ru_nvcsw, usage.ru_nivcsw, thread_allocations()};
}

void ThreadCounts::add(const ThreadCounts& from, const ThreadCounts& to) {
  minor_faults += to.minor_faults - from.minor_faults;
  major_faults += to.major_faults - from.major_faults;
  voluntary += to.voluntary - from.voluntary;
  involuntary += to.involuntary - from.involuntary;
  if (to.allocations) allocations = allocations.value_or(0) + *to.allocations - from.allocations.value_or(0);
}

}  // namespace stepwire::realtime
