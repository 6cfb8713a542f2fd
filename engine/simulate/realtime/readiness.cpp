#include "engine/simulate/realtime/readiness.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "engine/simulate/realtime/machine.hpp"

namespace stepwire::realtime {

namespace {

std::string limit_text(rlim_t limit) {
  return limit == RLIM_INFINITY ? "unlimited" : std::to_string(limit);
}

/// Returns the permission of a limit; a root process needs none.
Readiness of_limit(const char* what, __rlimit_resource resource, rlim_t needed, const char* cure) {
  rlimit limit{};
  ::getrlimit(resource, &limit);
  return {what, limit_text(limit.rlim_cur), cure, ::geteuid() == 0 || limit.rlim_cur >= needed};
}

Readiness of_kernel(const Machine& machine) {
  const bool fits = machine.kernel.find("PREEMPT_RT") != std::string::npos ||
                    machine.kernel.find("PREEMPT RT") != std::string::npos;
  return {"kernel", machine.kernel, "a kernel with PREEMPT_RT bounds delays: Debian has linux-image-rt-amd64",
          fits};
}

Readiness of_isolation(const Machine& machine) {
  return {"isolated processors", machine.isolated.empty() ? "none" : machine.isolated,
          "isolcpus=N nohz_full=N rcu_nocbs=N in the kernel command line, then loop --cpu N",
          !machine.isolated.empty()};
}

Readiness of_governor(const Machine& machine) {
  const bool unknown = machine.governor.empty();
  return {"governor", unknown ? "not known" : machine.governor,
          "'cpupower frequency-set -g performance' keeps the frequency",
          unknown || machine.governor == "performance"};
}

Readiness of_virtual_machine(const Machine& machine) {
  return {"machine", machine.virtual_machine ? "virtual" : "not virtual",
          "a host may take the processor away at any time; use a machine of its own",
          !machine.virtual_machine};
}

/// Interrupts reach an isolated processor unless their mask leaves it out.
Readiness of_interrupts() {
  std::string mask;
  std::getline(std::ifstream("/proc/irq/default_smp_affinity") >> std::ws, mask);
  const bool all = mask.find_first_not_of("f,") == std::string::npos;
  return {"interrupts", fmt::format("mask {}", mask.empty() ? "not known" : mask),
          "irqaffinity=0 in the kernel command line keeps them from the other processors",
          !all && !mask.empty()};
}

Readiness of_latency_file() {
  const bool may = ::access("/dev/cpu_dma_latency", W_OK) == 0;
  return {"deep sleep", may ? "may be prevented" : "may not be prevented",
          "permission to write /dev/cpu_dma_latency, by a rule of udev for your group", may};
}

Readiness of_throttling() {
  std::string time;
  std::getline(std::ifstream("/proc/sys/kernel/sched_rt_runtime_us"), time);
  return {"throttling", time.empty() ? "not known" : time + " us of each second",
          "'sysctl kernel.sched_rt_runtime_us=-1' lets a real-time thread have its whole processor",
          time == "-1"};
}

}  // namespace

std::vector<Readiness> readiness() {
  const Machine machine = Machine::here();
  return {of_kernel(machine),
          of_virtual_machine(machine),
          of_isolation(machine),
          of_governor(machine),
          of_interrupts(),
          of_latency_file(),
          of_throttling(),
          of_limit("priority", RLIMIT_RTPRIO, 81,
                   "'@realtime - rtprio 99' in /etc/security/limits.d allows fifo:80 and a guard above"),
          of_limit("locked memory", RLIMIT_MEMLOCK, RLIM_INFINITY,
                   "'@realtime - memlock unlimited' in /etc/security/limits.d")};
}

}  // namespace stepwire::realtime
