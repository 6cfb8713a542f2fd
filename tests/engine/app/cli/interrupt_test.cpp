#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

Done interrupted(const Scratch& folder, const std::vector<std::string>& arguments) {
  Call call;
  call.arguments = arguments;
  call.interrupt_after = 1.5;  // [s] also on a busy machine some rows have been computed by then
  return run_program(folder, call);
}

}  // namespace

TEST_CASE("an interrupted run ends with 130 and keeps what was recorded") {
  const Scratch folder;
  folder.file(
      "endless.yaml",
      endless_yaml +
          "figure: {plot: lines, x: time, y: lag}\nclaims:\n  - {that: it swings, max: lag, at_least: 0}\n");
  const Done done = interrupted(folder, {"run", "endless.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(done.code == 130);
  const auto table = stepwire::table::read_csv(folder.path("out/signals.csv"));
  CHECK(table.rows() > 1);
  CHECK(table.rows() < 100'000);
  CHECK(stepwire::mat::read_mat(folder.path("out/signals.mat")).find("lag")->values ==
        table.find("lag")->values);
  const auto run = nlohmann::json::parse(content_of(folder.path("out/run.json")));
  CHECK(run["interrupted"] == true);
  CHECK(run["ticks"] > 0);
  CHECK(nlohmann::json::parse(content_of(folder.path("out/claims.json")))[0]["holds"] == false);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out"))) {
    CHECK(entry.path().extension() != ".part");
    CHECK(entry.path().extension() != ".svg");
  }
}

TEST_CASE("an interrupted sweep keeps the runs that were begun, and files that wait are left") {
  const Scratch folder;
  folder.file("a.yaml", endless_yaml + "sweep: {lag.tau: {from: 0.1 s, to: 0.2 s, count: 20}}\n");
  folder.file("b.yaml", lag_yaml);
  const Done done = interrupted(folder, {"run", "a.yaml", "b.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(done.code == 130);
  CHECK(stepwire::table::read_csv(folder.path("out/a/signals.csv")).rows() > 1);
  CHECK_FALSE(std::filesystem::exists(folder.path("out/b")));
}

namespace {

/// A program of this name ahead on the PATH, which notes its process and one that it has begun, and hangs.
Call with_hanging(const Scratch& folder, const std::string& name, const std::vector<std::string>& arguments) {
  std::filesystem::create_directories(folder.path("bin"));
  const std::string script = folder.file(
      "bin/" + name,
      "#!/bin/sh\n[ \"$1\" = --version ] && { echo fake 1; exit 0; }\nsleep 300 &\n"
      "echo $$ $! > " +
          folder.path("ids.new") + "\nmv " + folder.path("ids.new") + " " + folder.path("ids") + "\nwait\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  Call call;
  call.arguments = arguments;
  call.environment["PATH"] = folder.path("bin") + ":/usr/bin:/bin";
  call.environment["CXX"] = folder.path("bin/c++");
  call.environment["STEPWIRE_CACHE"] = folder.path("cache");
  call.environment["TMPDIR"] = folder.path("tmp");
  std::filesystem::create_directories(folder.path("tmp"));
  return call;
}

/// True if one of the noted processes still runs after two seconds; a zombie has ended.
bool hanging_goes_on(const Scratch& folder) {
  std::ifstream ids(folder.path("ids"));
  for (std::string id; ids >> id;) {
    for (int look = 0; look < 400; ++look) {
      std::ifstream status("/proc/" + id + "/stat");
      std::string number, name, state;
      if (!(status >> number >> name >> state) || state == "Z") break;
      if (look == 399) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  return false;
}

std::ptrdiff_t pieces_in(const std::string& folder) {
  std::ptrdiff_t count = 0;
  std::error_code none;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none))
    count += entry.path().extension() == ".part";
  return count;
}

const std::string device_yaml = R"(stepwire: 1
title: a device
step: 1 ms
stop: 1 s
outputs: {current: {signal: wave, safe: 0.25}}
blocks:
  wave: {block: Sine, amplitude: 1, frequency: 1 Hz}
record: [wave]
)";

}  // namespace

TEST_CASE("what still reads its files ends at the first signal") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(::mkfifo(folder.path("units").c_str(), 0600) == 0);
  for (const std::string verb : {"run", "check", "draw", "flatten"}) {
    Call call;
    call.arguments = {verb, "lag.yaml"};
    call.environment["UDUNITS2_XML_PATH"] = folder.path("units");  // a pipe without a writer
    call.interrupt_after = 0.2;
    const auto start = std::chrono::steady_clock::now();
    CHECK(run_program(folder, call).code != 0);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  }
}

TEST_CASE(
    "a compiler, gnuplot or node that hangs is ended by an interruption with what it began, and nothing "
    "stays") {
  for (const std::string name : {"c++", "gnuplot", "node"}) {
    for (const std::vector<int>& signals : {std::vector<int>{SIGHUP}, {SIGTERM, SIGINT}}) {
      const Scratch folder;
      folder.file("lag.yaml", lag_yaml);
      const std::vector<std::string> arguments =
          name == "node"
              ? std::vector<std::string>{"draw", "lag.yaml", "-o", "out/lag.svg"}
              : std::vector<std::string>{"run", "lag.yaml", "--engine", "compiled", "--out", "out"};
      Call call = with_hanging(folder, name, arguments);
      if (name == "gnuplot") call.arguments[3] = "interpreted";
      call.interrupt_when = folder.path("ids");
      call.signals = signals;
      const Done done = run_program(folder, call);
      INFO(name << ": " << done.err);
      CHECK((done.code == 130 || (signals.size() == 2 && done.code > 128)));
      CHECK(done.seconds < 20.0);
      CHECK_FALSE(hanging_goes_on(folder));
      CHECK(pieces_in(folder.path("")) == 0);
      for (int look = 0; look < 400 && !std::filesystem::is_empty(folder.path("tmp")); ++look)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      CHECK(std::filesystem::is_empty(folder.path("tmp")));
    }
  }
}

TEST_CASE("a compiler, gnuplot or node that hangs is ended after a limit, and that is said") {
  for (const std::string name : {"c++", "gnuplot", "node"}) {
    const Scratch folder;
    folder.file("lag.yaml", lag_yaml);
    Call call = with_hanging(
        folder, name,
        {"run", "lag.yaml", "--engine", name == "c++" ? "compiled" : "interpreted", "--out", "out"});
    if (name == "node") call.arguments = {"draw", "lag.yaml", "-o", "lag.svg"};
    call.environment["STEPWIRE_HELPER_LIMIT"] = "0.3";
    const Done done = run_program(folder, call);
    INFO(name << ": " << done.err);
    CHECK((name == "c++" || done.code == 3));
    CHECK(lines_of(done.err).size() <= 2);
    CHECK_THAT(done.err, Contains("does not come to an end and was ended"));
    CHECK_FALSE(hanging_goes_on(folder));
  }
}

TEST_CASE("a loop that is interrupted before it begins ends with 130") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const double after : {0.15, 0.2, 0.3}) {
    Call call;
    call.arguments = {"loop", "lag.yaml", "--rate", "100", "--duration", "60", "--policy", "other"};
    call.interrupt_after = after;
    call.signals = {SIGTERM};
    const Done done = run_program(folder, call);
    INFO(after << ": " << done.err);
    CHECK(done.code == 130);
  }
}

TEST_CASE("a loop ends with its recording written, however many signals come", "[full]") {
  for (const std::vector<int>& signals :
       {std::vector<int>{SIGHUP}, {SIGTERM}, {SIGINT, SIGINT}, {SIGTERM, SIGINT, SIGHUP, SIGINT}}) {
    const Scratch folder;
    folder.file("device.yaml", device_yaml);
    Call call;
    call.arguments = {"loop",     "device.yaml", "--rate",   "200",         "--duration", "100",
                      "--policy", "other",       "--engine", "interpreted", "--out",      "out"};
    call.interrupt_after = 2.0;
    call.signals = signals;
    const Done done = run_program(folder, call);
    INFO(done.err);
    CHECK(done.code == 130);
    CHECK(done.seconds < 30.0);
    CHECK(nlohmann::json::parse(content_of(folder.path("out/loop.json"))).is_object());
    CHECK(stepwire::table::read_csv(folder.path("out/signals.csv")).rows() > 3);
    CHECK_THAT(content_of(folder.path("out/loop.svg")), Contains("</svg>"));
    CHECK(pieces_in(folder.path("out")) == 0);
    CHECK(run_program(folder, {"verify", "out"}).code == 0);
  }
}
