#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

/// Runs `work` in a child that the kernel kills at its first system call; true if it came to its end.
template <class Work>
bool runs_without_system_calls(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(2);
    work();
    syscall(SYS_exit, 0);  // the plain exit, which strict mode lets pass
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  const bool no_strict_mode = WIFEXITED(status) && WEXITSTATUS(status) == 2;
  if (no_strict_mode) WARN("this kernel has no strict seccomp mode; nothing was checked");
  return no_strict_mode || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace

TEST_CASE("a system call is seen") {
  CHECK_FALSE(runs_without_system_calls([] { syscall(SYS_getppid); }));
}

TEST_CASE("ten thousand steps make no system call") {
  for (const solve::SolverKind& kind : solve::solver_kinds()) {
    const plan::Plan plan = plan_text(R"(step: 1 ms
stop: 20 s
blocks:
  noise: {block: Noise, seed: 1, every: 10 ms}
  wave: {block: Sine, frequency: 3 Hz}
  drive: {block: Sum, u: [noise, wave]}
  damper: {block: MRDamper, preset: rd-1097-01, velocity: wave, current: 0.2 A}
  plant: {block: TransferFunction, numerator: [1], denominator: [1, 0.2, 9], u: drive}
  late: {block: Delay, delay: 50 ms, u: plant}
  hold: {block: UnitDelay, u: late, every: 5 ms}
solver: )" + kind.name);
    Executor simulation(plan);
    INFO(kind.name);
    CHECK(runs_without_system_calls([&] {
      for (int tick = 0; tick < 10'000; ++tick) {
        simulation.evaluate();
        simulation.advance();
      }
    }));
  }
}

}  // namespace stepwire::run
