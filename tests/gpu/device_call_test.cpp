#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace stepwire::device {
using Catch::Contains;

namespace {

/// An oscillator under a sine, swept over its damping. Placeholders: number of runs, lines of the sweep,
/// blocks.
constexpr const char* swing = R"(stepwire: 1
title: Damping
step: 5 ms
stop: 2 s
solver: rk4
parameters:
  ratio: {{value: 0.2, doc: of damping}}
sweep:
  ratio: {{from: 0, to: 0.8, count: {0}}}
{1}
blocks:
  shaker: {{block: Sine, amplitude: 1 N, frequency: 1 Hz}}
  swing: {{diagram: stepwire/oscillator, force: shaker, frequency: 1 Hz, ratio: $ratio}}
{2}
record: [swing.x]
)";

/// Folder with a diagram, a cache and the libraries of a fake GPU, in which the program is called.
class Calls {
 public:
  explicit Calls(const std::string& diagram) {
    for (const char* sub : {"cache", "kernels"})
      std::filesystem::create_directory(folder_.path() + "/" + sub);
    std::filesystem::permissions(folder_.path() + "/cache", std::filesystem::perms::owner_all);
    io::write_file(folder_.path() + "/swing.yaml", diagram);
  }

  /// Calls `run` with these options and variables of the environment. The result has both outputs.
  subprocess::ProcessResult run(const std::vector<std::string>& options,
                                std::vector<std::string> variables = {}) const {
    subprocess::ProcessCall call{.command = {STEPWIRE_PROGRAM, "run", folder_.path() + "/swing.yaml"}};
    call.command.insert(call.command.end(), options.begin(), options.end());
    const std::string tools = std::string(STEPWIRE_SOURCE_DIR) + "/tests/support/cuda";
    call.variables = std::move(variables);
    call.variables.push_back(fmt::format("PATH={}:{}", tools, std::getenv("PATH")));
    call.variables.push_back("FAKE_CUDA_FOLDER=" + folder_.path() + "/kernels");
    call.variables.push_back("STEPWIRE_CACHE=" + folder_.path() + "/cache");
    call.variables.push_back(std::string("LD_LIBRARY_PATH=") + FAKE_CUDA);
    return subprocess::run_process(call);
  }

  /// Returns the table of a call.
  std::string csv(const std::vector<std::string>& options, std::vector<std::string> variables = {}) const {
    std::vector<std::string> all{"--csv", "-"};
    all.insert(all.end(), options.begin(), options.end());
    return run(all, std::move(variables)).output;
  }

  std::size_t kernels() const {
    const std::filesystem::directory_iterator first(folder_.path() + "/kernels");
    return static_cast<std::size_t>(std::distance(first, {}));
  }
  const std::string& path() const { return folder_.path(); }

 private:
  subprocess::ScratchFolder folder_;
};

std::string diagram(int count, const char* keep = "", const char* more = "") {
  return fmt::format(fmt::runtime(swing), count, keep, more);
}

/// Returns messages up to the report of the run, which has its duration.
std::string without_duration(const std::string& text) {
  return text.substr(0, text.find("ticks, "));
}

void check_same(const Calls& calls) {
  const std::string on_processor = calls.csv({});
  CHECK(on_processor.size() > 1000);
  CHECK(calls.csv({"--device", "gpu"}) == on_processor);
  CHECK(calls.kernels() == 1);
}

}  // namespace

TEST_CASE("a sweep on a GPU gives the rows of one on the processor") {
  const Calls calls(diagram(100));
  check_same(calls);
  const auto result = calls.run({"--device", "gpu", "--json"});
  CHECK_THAT(result.output, Contains("\"name\": \"Fake GPU\"") && Contains("\"runs\": 100"));
  CHECK(result.errors == "");
  CHECK(calls.kernels() == 1);  // the kernel is that of the cache
}

TEST_CASE("a sweep on a GPU keeps last rows, and numbers of all rows") {
  check_same(Calls(diagram(200, "  keep: final")));
  check_same(Calls(diagram(200, "  keep: {most: max(swing.x), rest: final(swing.x)}")));
}

TEST_CASE("a run of a sweep on a GPU ends by itself") {
  const std::string stop = "stop_when: swing.x > 30 mm\n";
  check_same(Calls(stop + diagram(100)));
  const Calls calls(diagram(100, "",
                            "  inside: {block: Expression, u: swing.x, expression: abs(u) <= 40 mm}\n  "
                            "limit: {block: Assert, u: inside}"));
  const auto alone = calls.run({"--csv", "-"}), together = calls.run({"--csv", "-", "--device", "gpu"});
  CHECK(alone.output == together.output);
  CHECK_THAT(alone.errors, Contains("what is asserted does not hold"));
  CHECK(without_duration(alone.errors) == without_duration(together.errors));
  CHECK(alone.status == together.status);
}

TEST_CASE("a sweep that cannot go to a GPU names the reason and runs on the processor") {
  const Calls calls(diagram(100));
  const std::string expected = calls.csv({});
  const auto refused = [&](const std::string& variable, const char* reason) {
    const auto result = calls.run({"--csv", "-", "--device", "gpu"}, {variable});
    CHECK_THAT(result.errors, Contains(reason));
    CHECK(result.output == expected);
    CHECK(result.status == 0);
  };
  refused("FAKE_CUDA=none", "on the processor, since the driver finds no GPU");
  refused("FAKE_CUDA=old", "the GPU is older than");
  refused("FAKE_CUDA=full", "the device cannot reserve memory: out of memory");
  refused("FAKE_CUDA=broken", "the device cannot run the kernel: unspecified launch failure");
  const Calls libm("functions: libm\n" + diagram(100));
  CHECK_THAT(libm.run({"--device", "gpu"}).errors, Contains("C library"));
  const Calls few(diagram(10));
  CHECK_THAT(few.run({"--device", "gpu"}).errors, Contains("fewer than 32 runs"));
  CHECK(few.run({"--device", "auto"}).errors == "");
}

TEST_CASE("a group that has no room on a GPU is run on the processor") {
  const Calls calls(diagram(200));
  const std::string expected = calls.csv({});
  CHECK(calls.csv({"--device", "gpu", "--threads", "2"}, {"FAKE_CUDA=late"}) == expected);
}

TEST_CASE("a device that is no word of --device is refused") {
  const Calls calls(diagram(100));
  const auto result = calls.run({"--device", "tpu"});
  CHECK_THAT(result.errors, Contains("does not take 'tpu'"));
}

TEST_CASE("an interruption ends a sweep on a GPU within a second") {
  const Calls calls(diagram(100, "  keep: final"));
  const std::string program = fmt::format(
      "PATH={0}/tests/support/cuda:$PATH LD_LIBRARY_PATH={1} FAKE_CUDA=slow FAKE_CUDA_FOLDER={2}/kernels "
      "STEPWIRE_CACHE={2}/cache {3} run {2}/swing.yaml --stop 100000s --device gpu & ",
      STEPWIRE_SOURCE_DIR, FAKE_CUDA, calls.path(), STEPWIRE_PROGRAM);
  // The shell waits until the kernel is compiled and has begun.
  const auto result = subprocess::run_process(
      {.command = {"sh", "-c",
                   program + "while [ -z \"$(ls " + calls.path() +
                       "/kernels)\" ]; do sleep 0.1; done; sleep 5; date +%s%N; kill -INT $!; wait $!; "
                       "date +%s%N"}});
  INFO(result.output << result.errors);
  const std::size_t line = result.output.find('\n');
  REQUIRE(line != std::string::npos);
  const double killed = std::stod(result.output.substr(0, line));
  const double ended =
      std::stod(result.output.substr(result.output.rfind('\n', result.output.size() - 2) + 1));
  CHECK(ended - killed < 2e9);  // a busy machine takes a part of it
}

}  // namespace stepwire::device
