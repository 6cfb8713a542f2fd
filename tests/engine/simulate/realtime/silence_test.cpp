// A loop thread allocates no memory and makes no system call but to sleep.
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <memory>
#include <thread>

#include "engine/simulate/realtime/allocations.hpp"
#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

const std::string busy_yaml = R"(step: 1 ms
inputs: {force: {unit: N, default: 1 N}}
outputs: {drive: {signal: drive, safe: 0}}
solver: rk4
blocks:
  noise: {block: Noise, seed: 1, every: 10 ms}
  drive: {block: Sum, u: [noise, late]}
  plant: {block: TransferFunction, numerator: [1], denominator: [1, 0.2, 9], u: drive}
  late: {block: Delay, delay: 50 ms, u: plant}
  formula: {block: Expression, u: plant, expression: sin(u) > 0}
  push: {block: Gain, gain: 2, u: force}
record:
  - {signals: [drive, plant]}
  - {every: 5 ms, signals: [push]}
)";

constexpr std::int64_t wake_ups = 2000;

#ifdef __SANITIZE_THREAD__
constexpr bool another_thread = true;  // the sanitizer's, which would outlive the one that ends
#else
constexpr bool another_thread = false;
#endif

/// A device at whose first read the kernel begins to end the program for any system call but read, write and
/// exit, and which ends it as it should at the last.
class Sealed : public Device {
 public:
  void read(double*) noexcept override {
    if (reads == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(2);
    if (++reads == wake_ups) syscall(SYS_exit, 0);
  }
  void write(const double*) noexcept override {}

 private:
  std::int64_t reads = 0;
};

}  // namespace

TEST_CASE("requests for memory are counted for each thread by itself, whoever makes them") {
  const auto before = thread_allocations();
  if (!before) {
    WARN("nobody counts in this build");
    return;
  }
  const auto number = std::make_unique<double>(1.0);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(100, *number);
  void* volatile zeros = std::calloc(3, 5);
  std::free(zeros);
  CHECK(vector.sum() == 100.0);
  CHECK(*thread_allocations() - *before == 3);
  const auto here = thread_allocations();
  std::int64_t there = -1;
  std::thread other([&] { there = *thread_allocations(); });
  other.join();
  CHECK(there < *here);
}

TEST_CASE("a loop that records two thousand wake-ups asks for no memory") {
  LoopRig rig(busy_yaml, options_of(wake_ups));
  rig.device.read_takes[100] = 5 * ms;  // misses are part of it
  rig.device.input = [](std::int64_t read) { return 0.001 * static_cast<double>(read); };
  rig.device.written.reserve(2 * wake_ups);
  rig.device.written_at.reserve(2 * wake_ups);
  rig.device.last.reserve(2);
  rig.loop.serve(wake_ups);
  CHECK(rig.loop.deadlines().missed() > 0);
  CHECK(rig.recorder.rows() > 0);
  CHECK(rig.loop.counts().allocations.value_or(0) == 0);
}

TEST_CASE("two thousand wake-ups make no system call but what the clock's sleep makes") {
  if (another_thread) {
    WARN("skipped: a thread of the sanitizer is part of every program");
    return;
  }
  const plan::Plan plan = plan_text(busy_yaml);
  RowRing ring(1 << 14);  // it runs full, which must go without a call too
  LoopRecorder recorder(plan, ring);
  const pid_t child = fork();
  if (child == 0) {
    FakeClock clock;
    Sealed device;
    Loop loop(plan, options_of(wake_ups), device, clock, &recorder);
    loop.serve(wake_ups);
    _exit(3);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 2) {
    WARN("this kernel has no strict seccomp mode; nothing was checked");
    return;
  }
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

}  // namespace stepwire::realtime
