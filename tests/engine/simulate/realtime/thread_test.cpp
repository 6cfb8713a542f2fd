#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "engine/simulate/realtime/allocations.hpp"
#include "engine/simulate/realtime/machine.hpp"
#include "engine/simulate/realtime/serve.hpp"
#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

/// Returns the messages of a child without any privilege that tries to become a real-time thread.
std::string refused_to_a_nobody() {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_MEMLOCK, &none);
    setrlimit(RLIMIT_RTPRIO, &none);
    if (setgid(65534) != 0 || setuid(65534) != 0) _exit(2);
    const RealTimeThread thread(ThreadPolicy{80}, std::nullopt);
    std::string text;
    for (const std::string& line : thread.refused()) text += line + "\n";
    text += RealTimeThread::policy_in_force() + "\n";
    _exit(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text(4096, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ends[0], text.data(), text.size()))));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return text;
}

}  // namespace

TEST_CASE("the real clock never wakes before its deadline, asleep or spinning") {
  for (const std::int64_t spin : {std::int64_t{0}, ms / 10, 5 * ms}) {
    SystemClock clock(spin);
    for (int k = 0; k < 5; ++k) {
      const std::int64_t deadline = clock.now() + ms / 5;
      clock.sleep_until(deadline);
      CHECK(clock.now() >= deadline);
    }
    clock.sleep_until(clock.now() - 1000 * ms);
  }
}

TEST_CASE("a loop in a thread of its own serves all its deadlines and says how the thread ran") {
  const plan::Plan plan = plan_text(counting_yaml);
  SystemClock clock;
  NoDevice device;
  Loop loop(plan, options_of(20), device, clock, nullptr);
  const Served served = serve_in_real_time(loop, 20, ThreadPolicy{std::nullopt}, std::nullopt);
  CHECK(served.policy == "other");
  CHECK(loop.end() == Loop::End::done);
  CHECK(loop.measurements().wake_up().count() == 20);
  CHECK(loop.counts().allocations.value_or(0) == 0);
}

TEST_CASE("what is not allowed is said in one line each, with the reason and the cure, and it runs on") {
  if (geteuid() != 0) {
    WARN("skipped: only root can become nobody");
    return;
  }
  const std::string text = refused_to_a_nobody();
  if (text.empty()) {
    WARN("skipped: no child here can become nobody");
    return;
  }
  INFO(text);
  const bool sanitized = !thread_allocations();  // a sanitizer's mlockall() does nothing and reports success
  if (!sanitized)
    CHECK_THAT(text, Catch::Contains("memory is not locked") && Catch::Contains("CAP_IPC_LOCK"));
  CHECK(std::count(text.begin(), text.end(), '\n') >= 2);
  CHECK_THAT(text, Catch::Contains("the thread does not run with fifo:80 (Operation not permitted)") &&
                       Catch::Contains("ulimit -r 80") && Catch::EndsWith("\nother\n"));
}

TEST_CASE("the words for policies are read, and nothing else") {
  CHECK(parse_policy("other") == ThreadPolicy{std::nullopt});
  CHECK(parse_policy("fifo:1") == ThreadPolicy{1});
  CHECK(parse_policy("fifo:99") == ThreadPolicy{99});
  for (const char* text : {"", "fifo", "fifo:", "fifo:0", "fifo:100", "fifo:8x", "rr:3", "Other"}) {
    INFO(text);
    CHECK_FALSE(parse_policy(text));
  }
  CHECK(policy_text({80}) == "fifo:80");
  CHECK(policy_text({std::nullopt}) == "other");
}

TEST_CASE("a machine knows its processor and its kernel") {
  const Machine machine = Machine::here();
  CHECK(machine.processors >= 1);
  CHECK_FALSE(machine.kernel.empty());
  CHECK_FALSE(allowed_cpus().empty());
}

TEST_CASE("of a kernel's command line only the words that matter for timing are kept") {
  CHECK(timing_words("BOOT_IMAGE=/vmlinuz root=UUID=1 quiet isolcpus=2-3 nohz_full=2-3 rcu_nocbs=2-3 "
                     "mitigations=off preempt=full token=secret isolcpusx=1") ==
        "isolcpus=2-3 nohz_full=2-3 rcu_nocbs=2-3 mitigations=off preempt=full");
  CHECK(timing_words("quiet splash").empty());
}

}  // namespace stepwire::realtime
