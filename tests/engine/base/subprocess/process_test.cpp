#include "engine/base/subprocess/process.hpp"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "engine/base/io/environment_error.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::subprocess {
using Catch::Contains;
using End = ProcessResult::End;

namespace {

ProcessCall shell(const std::string& script) {
  return {.command = {"sh", "-c", script}};
}

double seconds_of(const ProcessCall& call, End end) {
  const auto start = std::chrono::steady_clock::now();
  CHECK(run_process(call).end == end);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// True if a process with this number still runs; a zombie has ended.
bool goes_on(const std::string& id) {
  std::ifstream status("/proc/" + id + "/stat");
  std::string number, name, state;
  return static_cast<bool>(status >> number >> name >> state) && state != "Z";
}

}  // namespace

TEST_CASE("A program gets its input and gives its output, its complaints and its status") {
  ProcessCall call = shell("cat; echo wrong >&2; exit 3");
  call.input = std::string(300'000, 'x');  // more than any pipe holds
  const ProcessResult result = run_process(call);
  CHECK(result.end == End::exited);
  CHECK(result.status == 3);
  CHECK(result.output == call.input);
  CHECK(result.errors == "wrong");
  CHECK_FALSE(result.succeeded());
  CHECK(result.problem("cat") == "wrong");
}

TEST_CASE("A program that is not there, is killed, or hangs is told apart") {
  CHECK(run_process({.command = {"/no/such/program"}}).problem("it") == "it could not be run");
  CHECK(run_process(shell("kill -9 $$")).problem("it") == "it was killed by a signal");
  ProcessCall hangs = shell("sleep 100");
  hangs.limit = std::chrono::milliseconds(100);
  CHECK(seconds_of(hangs, End::overdue) < 10.0);
  CHECK_THAT(run_process(hangs).problem("it"), Contains("does not come to an end"));
  CHECK_THROWS_AS(run_helper("it", hangs), io::EnvironmentError);
}

TEST_CASE("A program that writes without end is ended, and of its complaints the beginning is kept") {
  ProcessCall endless = shell("yes");
  endless.max_output = 100'000;
  CHECK(run_process(endless).end == End::too_much);
  const ProcessResult loud = run_process(shell("yes | head -c 3000000 >&2"));
  CHECK(loud.succeeded());
  CHECK(loud.errors.size() < 100'000);
}

TEST_CASE("A stop ends a program at once, with all that it has begun") {
  const Scratch folder;
  for (const bool by_interruption : {false, true}) {
    std::stop_source source;
    ProcessCall call = shell("sleep 100 & echo $! > " + folder.path("id") + "; wait");
    call.stop = source.get_token();
    std::jthread stopper([&] {
      while (!std::filesystem::exists(folder.path("id")) || std::filesystem::file_size(folder.path("id")) < 2)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      by_interruption ? void(processes_stop() = true) : void(source.request_stop());
    });
    CHECK(seconds_of(call, End::stopped) < 20.0);
    stopper.join();
    processes_stop() = false;
    std::string id;
    std::ifstream(folder.path("id")) >> id;
    for (int look = 0; look < 1000 && goes_on(id); ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    CHECK_FALSE(goes_on(id));
    std::filesystem::remove(folder.path("id"));
  }
}

TEST_CASE("While processes are stopped none begins") {
  processes_stop() = true;
  CHECK(run_process(shell("exit 0")).end == End::stopped);
  CHECK_THROWS_AS(run_helper("it", shell("exit 0")), ProcessStopped);
  processes_stop() = false;
  CHECK(run_process(shell("exit 0")).succeeded());
}

TEST_CASE("What a program leaves in the background is not waited for") {
  CHECK(seconds_of(shell("sleep 100 & exit 0"), End::exited) < 20.0);
}

TEST_CASE("Temporary files of a program go with it") {
  const ProcessResult result = run_process(shell("touch \"$TMPDIR/left\"; echo $TMPDIR"));
  const std::string folder = result.output.substr(0, result.output.find('\n'));
  REQUIRE_FALSE(folder.empty());
  CHECK_FALSE(std::filesystem::exists(folder));
}

TEST_CASE("A program finds signals as it expects them, whatever this one ignores") {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  CHECK(run_process(shell("kill -PIPE $$; exit 5")).end == End::killed);
  std::signal(SIGPIPE, before);
}

}  // namespace stepwire::subprocess
