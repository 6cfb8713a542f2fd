#include "engine/simulate/realtime/thread_counts.hpp"

#include <sys/resource.h>

#include "engine/simulate/realtime/allocations.hpp"

namespace stepwire::realtime {

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
