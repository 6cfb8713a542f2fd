// The verb `loop`. The timing of a machine is never checked, only the reports about it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

const std::string slide_yaml = R"(stepwire: 1
title: A lag with an input
step: 1 ms
stop: 0.1 s
solver: rk4
inputs: {target: {default: 2, doc: where to go}}
outputs: {drive: {signal: lag, safe: 0}}
blocks:
  lag: {block: Lag, u: target, tau: 0.05 s}
record: [lag]
claims:
  - {that: it never gets there, final: lag, at_most: 0}
)";

Done loop(const Scratch& folder, const std::string& yaml, std::vector<std::string> options) {
  folder.file("a.yaml", yaml);
  options.insert(options.begin(), {"loop", "a.yaml"});
  return run_program(folder, options);
}

nlohmann::json report_in(const Scratch& folder) {
  return nlohmann::json::parse(content_of(folder.path("out/loop.json")));
}

}  // namespace

TEST_CASE("a loop serves all deadlines, leaves its files, and judges no claims") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml, {"--duration", "0.3", "--policy", "other", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(done.out, Contains("of 300 deadlines") && Contains("wake-up latency") && Contains("missed ") &&
                           Contains("the file's stop of 0.1 s does not end a loop") &&
                           Contains("written to out"));
  const nlohmann::json report = report_in(folder);
  CHECK(report["end"] == "done");
  CHECK(report["deadlines"]["passed"] == 300);
  CHECK(report["deadlines"]["missed"] ==
        report["deadlines"]["late"].get<int>() + report["deadlines"]["dropped"].get<int>());
  for (const char* each : {"wake_up", "response"}) {
    CHECK(report[each]["count"] == 300);
    int sum = 0;
    for (const nlohmann::json& bin : report[each]["histogram"]) sum += bin[1].get<int>();
    CHECK(sum == 300);
  }
  CHECK(report["step"]["count"] == report["steps"]);
  CHECK(report["worst"]["wake_up"].size() == 200);
  CHECK(report["thread"]["policy"] == "other");
  if (!report["thread"]["allocations"].is_null()) CHECK(report["thread"]["allocations"] == 0);
  CHECK_FALSE(report["machine"]["kernel"].get<std::string>().empty());
  CHECK(report["rows"]["lost_to_ring"] == 0);
  const auto signals = stepwire::table::read_csv(folder.path("out/signals.csv"));
  REQUIRE(signals.columns.size() == 4);
  CHECK(static_cast<int>(signals.rows()) == report["ticks"]);
  for (std::size_t row = 0; row < signals.rows(); ++row)
    CHECK(signals.find("tick")->values[row] == static_cast<double>(row));
  CHECK(signals.find("wall")->unit == "s");
  const auto inputs = stepwire::table::read_csv(folder.path("out/inputs.csv"));
  CHECK(inputs.rows() == signals.rows());
  CHECK(inputs.find("target")->values.front() == 2.0);
  CHECK_THAT(content_of(folder.path("out/loop.svg")), Contains("A lag with an input: 1000 Hz, other"));
}

TEST_CASE("what a loop leaves is verified bit by bit, inputs and dropped deadlines included") {
  const Scratch folder;
  REQUIRE(loop(folder, slide_yaml,
               {"--duration", "0.3", "--rate", "500", "--policy", "other", "--set", "lag.tau=0.07 s", "--out",
                "out"})
              .code == 0);
  const auto ticks = report_in(folder)["ticks"].get<int>();
  const Done done = run_program(folder, {"verify", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("1 signal in " + std::to_string(ticks) + " rows: all bits agree\n"));
  std::filesystem::remove(folder.path("out/loop.json"));
  const Done cut = run_program(folder, {"verify", "out"});
  CHECK(cut.code == 0);
  CHECK_THAT(cut.out, Contains("all bits agree; there is no loop.json: the loop has not come to its end"));
}

TEST_CASE(
    "a diagram whose events are located runs in a loop from tick to tick, which is reported and verified") {
  const Scratch folder;
  const Done done = loop(folder, R"(stepwire: 1
title: A lag that a sine resets
step: 1 ms
stop: 0.1 s
solver: rk4
events: locate
blocks:
  wave: {block: Sine, frequency: 33 Hz}
  lag: {block: Lag, u: 1, tau: 0.05 s, reset: wave}
record: [lag]
)",
                         {"--duration", "0.2", "--policy", "other", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("'events: locate' does not hold in a loop"));
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a loop of compiled code gives the bits that the interpreter gives") {
  if (!stepwire::codegen::Compiler().found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const Scratch folder;
  REQUIRE(loop(folder, slide_yaml,
               {"--duration", "0.3", "--policy", "other", "--engine", "compiled", "--out", "out"})
              .code == 0);
  CHECK(report_in(folder)["diagram"]["engine"] == "compiled");
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("what a loop is asked wrongly is refused with 2, with what would be right, all at once") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml,
                         {"--rate", "fast", "--duration", "0", "--policy", "fifo:100", "--overrun", "stop",
                          "--spin", "2 m", "--cpu", "4711"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("--rate fast: must be a number in Hz, such as 1000 or '2 kHz'\n") &&
                           Contains("--policy fifo:100: must be fifo:PRIORITY") &&
                           Contains("--overrun stop: must be skip, catch-up, or stop:N") &&
                           Contains("--spin 2 m: must be a number in s") &&
                           Contains("--cpu 4711: is not there; this program may use 0"));
  for (const auto& [option, text] : std::vector<std::pair<std::string, std::string>>{{"--rate", "0.5"},
                                                                                     {"--rate", "1e7"},
                                                                                     {"--duration", "1e-9"},
                                                                                     {"--spin", "1 ms"},
                                                                                     {"--spin", "-1"}}) {
    const Done refused = loop(folder, slide_yaml, {option, text});
    INFO(refused.err);
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Catch::StartsWith(option + " " + text + ": must be "));
  }
}

TEST_CASE("a rate whose period is no whole number of steps is refused with its place") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml, {"--rate", "2 kHz"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Catch::StartsWith("a.yaml:3:7: step: the period of 2000 Hz, 0.0005 s, is no whole "
                                         "multiple of the step 0.001 s; e.g. a rate of 1000 Hz"));
  CHECK(loop(folder, slide_yaml,
             {"--rate", "2 kHz", "--set", "step=0.5 ms", "--duration", "20 ms", "--policy", "other"})
            .code == 0);
}

TEST_CASE("deadlines that cannot be met end a loop with 1 where it is to stop, and are reported where not") {
  const Scratch folder;
  const std::vector<std::string> hopeless{"--rate", "1 MHz",    "--set", "step=1 us", "--duration",
                                          "10 ms",  "--policy", "other", "--out",     "out"};
  const Done done = loop(folder, slide_yaml, hopeless);
  INFO(done.err);
  CHECK(done.code == 0);
  nlohmann::json report = report_in(folder);
  CHECK(report["deadlines"]["passed"] == 10'000);
  CHECK(report["deadlines"]["missed"] > 0);
  CHECK(report["wake_up"]["count"] == 10'000);
  CHECK(report["response"]["count"] == 10'000);
  auto stopping = hopeless;
  stopping.insert(stopping.end(), {"--overrun", "stop:2"});
  const Done stopped = loop(folder, slide_yaml, stopping);
  CHECK(stopped.code == 1);
  CHECK_THAT(stopped.out, Contains("stopped after too many misses in a row"));
  report = report_in(folder);
  CHECK(report["deadlines"]["longest_row"] >= 2);
  CHECK(report["deadlines"]["passed"] < 10'000);
}

TEST_CASE("catch-up runs every tick, however late") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml,
                         {"--rate", "100 kHz", "--set", "step=10 us", "--duration", "20 ms", "--policy",
                          "other", "--overrun", "catch-up", "--out", "out"});
  CHECK(done.code == 0);
  CHECK(report_in(folder)["steps"] == 2000);
}

TEST_CASE("an interrupted loop ends with 130, and what it has is reported and kept") {
  const Scratch folder;
  folder.file("a.yaml", slide_yaml);
  Call call;
  call.arguments = {"loop", "a.yaml", "--duration", "60 s", "--policy", "other", "--out", "out"};
  call.interrupt_after = 0.5;
  const Done done = run_program(folder, call);
  INFO(done.err);
  CHECK(done.code == 130);
  CHECK_THAT(done.out, Contains("interrupted: "));
  const nlohmann::json report = report_in(folder);
  CHECK(report["end"] == "interrupted");
  CHECK(report["deadlines"]["passed"] < 60'000);
  CHECK(static_cast<int>(stepwire::table::read_csv(folder.path("out/signals.csv")).rows()) ==
        report["ticks"]);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out")))
    CHECK(entry.path().extension() != ".part");
}

TEST_CASE("a full disk ends with 3 after the loop, with whole rows and a count of what is lost") {
  const Scratch folder;
  folder.file("a.yaml", slide_yaml);
  Call full;
  full.arguments = {"loop", "a.yaml", "--duration", "0.5", "--policy", "other", "--out", "out"};
  full.max_bytes_of_file = 6000;
  const Done done = run_program(folder, full);
  INFO(done.err);
  CHECK(done.code == 3);
  CHECK_THAT(done.out, Contains("of 500 deadlines") && Contains("because of the disk"));
  CHECK_THAT(done.err, Contains("signals.csv: File too large; ") && Contains(" rows are lost"));
  const std::string signals = content_of(folder.path("out/signals.csv"));
  CHECK_THAT(signals, Catch::StartsWith("time [s],tick,wall [s],lag\n") && Catch::EndsWith("\n"));
  CHECK_THAT(run_program(folder, {"verify", "out"}).out,
             Contains("all bits agree") && Contains("; there is no loop.json"));
}

TEST_CASE("a value that is not finite, or a condition of the diagram, ends a loop with 2 as it ends a run") {
  const Scratch folder;
  const Done done = loop(folder, R"(stepwire: 1
title: It runs away
step: 1 ms
stop: 1 s
blocks:
  t: {block: Clock}
  left: {block: Sum, signs: "+-", u: [10 ms, t]}
  inverse: {block: Divide, numerator: 1, denominator: left}
record: [left]
)",
                         {"--policy", "other", "--out", "out"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Catch::StartsWith("a.yaml:8:12: inverse.y: became inf at 0.01 s; the run ends here"));
  CHECK_THAT(done.out, Contains("ended by the diagram"));
  CHECK(stepwire::table::read_csv(folder.path("out/signals.csv")).rows() == 10);
}

TEST_CASE("a loop runs a file with a sweep once, with the file's own values") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml + "sweep: {lag.tau: [0.1 s, 0.2 s]}\n",
                         {"--duration", "20 ms", "--policy", "other"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("20 of 20 deadlines"));
}

TEST_CASE("without a folder nothing is written") {
  const Scratch folder;
  const Done done = loop(folder, slide_yaml, {"--duration", "20 ms", "--policy", "other"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, !Contains("recorded") && !Contains("written"));
  CHECK(folder.files() == 3);  // the diagram, and what the program printed
}

TEST_CASE("without cyclictest a baseline is refused with 3 and its package, before the loop") {
  const Scratch folder;
  folder.file("a.yaml", slide_yaml);
  Call bare;
  bare.arguments = {"loop", "a.yaml", "--baseline"};
  bare.environment["PATH"] = folder.path("empty");
  const Done done = run_program(folder, bare);
  CHECK(done.code == 3);
  CHECK(done.err == "cyclictest is not installed; on Debian it is in the package rt-tests\n");
  CHECK(done.out.empty());
}

TEST_CASE("a baseline of its own program stands beside the loop") {
  const Scratch folder;
  folder.file("a.yaml", slide_yaml);
  std::filesystem::create_directory(folder.path("bin"));
  folder.file("bin/cyclictest",
              "#!/bin/sh\necho '# Histogram'\necho '000007 000006'\necho '000009 000003'\n"
              "echo '# Max Latencies: 00031'\necho '# Histogram Overflows: 00001'\n");
  std::filesystem::permissions(folder.path("bin/cyclictest"), std::filesystem::perms::owner_all);
  Call call;
  call.arguments = {"loop",     "a.yaml", "--baseline", "--duration", "20 ms",
                    "--policy", "other",  "--out",      "out"};
  call.environment["PATH"] = folder.path("bin") + ":" + std::getenv("PATH");
  const Done done = run_program(folder, call);
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("cyclictest, by turns"));
  const nlohmann::json baseline = report_in(folder)["cyclictest"];
  CHECK(baseline["p50_us"] == 7);
  CHECK(baseline["p99_us"] == 31);
  CHECK(baseline["count"] == 10);
  CHECK_THAT(baseline["command"].get<std::string>(), Contains("-i1000") && Contains("--policy=other"));
}
