#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "tests/engine/cli/program.hpp"

using Catch::Contains;

namespace {

Call call(const std::vector<std::string>& arguments) {
  Call result;
  result.arguments = arguments;
  return result;
}

const std::string file_yaml =
    "stepwire: 1\ntitle: a record\nstep: 1 ms\nstop: 10 ms\nblocks:\n  press: {block: FromFile, file: PLACE, "
    "column: force}\n";

std::string from_file(const std::string& place) {
  std::string text = file_yaml;
  return text.replace(text.find("PLACE"), 5, place);
}

}  // namespace

TEST_CASE("a result folder that cannot be is refused before the run with 3") {
  const Scratch folder;
  folder.file("endless.yaml", endless_yaml);
  folder.file("taken", "a file");
  for (const std::string out : {"taken", "taken/below", "/proc/stepwire"}) {
    const Done done = run_program(folder, {"run", "endless.yaml", "--out", out});
    INFO(done.err);
    CHECK(done.code == 3);
    CHECK_THAT(done.err, Contains(out.substr(0, 5)));
  }
}

TEST_CASE("a result folder without permission is refused with 3") {
  if (::geteuid() == 0) {
    WARN("skipped: root may write everywhere");
    return;
  }
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  std::filesystem::create_directory(folder.path("closed"));
  std::filesystem::permissions(folder.path("closed"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "closed"}).code == 3);
}

TEST_CASE("a full disk ends with 3 and leaves no half file") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  std::filesystem::create_directory(folder.path("out"));
  folder.file("out/signals.csv", "of the run before\n");
  Call full = call({"run", "lag.yaml", "--out", "out"});
  full.most_bytes_of_file = 2000;
  const Done done = run_program(folder, full);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("out/signals.csv: "));
  CHECK(content_of(folder.path("out/signals.csv")) == "of the run before\n");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out")))
    CHECK(entry.path().extension() != ".part");
}

TEST_CASE("what cannot be printed ends with 3") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  Call full = call({"run", "lag.yaml"});
  full.out_to = "/dev/full";
  const Done done = run_program(folder, full);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("No space left on device"));
}

TEST_CASE("a reader who leaves early hears nothing") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  Call left = call({"run", "lag.yaml"});
  left.closed_pipe = true;
  const Done done = run_program(folder, left);
  CHECK(done.code == 128 + SIGPIPE);
  CHECK(done.err.empty());
}

TEST_CASE("without gnuplot a figure ends with 3, and the signals are kept") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  Call bare = call({"run", "lag.yaml", "--out", "out"});
  bare.environment["PATH"] = folder.path("empty");
  const Done done = run_program(folder, bare);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("gnuplot"));
  CHECK(lines_of(done.err).size() == 1);
  CHECK_THAT(content_of(folder.path("out/signals.csv")), Catch::StartsWith("time [s],"));
  CHECK_THAT(content_of(folder.path("out/claims.json")), Contains("the lag gets there"));
}

TEST_CASE("without the data folder a file in it ends with 3 and says what to set") {
  const Scratch folder;
  folder.file("a.yaml", from_file("data/press.csv"));
  Call bare = call({"run", "a.yaml"});
  bare.environment["STEPWIRE_DATA"] = std::nullopt;
  Done done = run_program(folder, bare);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Catch::StartsWith("a.yaml:6:34: press.file: ") && Contains("set STEPWIRE_DATA"));
  bare.environment["STEPWIRE_DATA"] = folder.path("nowhere");
  done = run_program(folder, bare);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("nowhere") && Contains("no folder"));
}

TEST_CASE("a data file that is not there, or is none, is a wrong name with its place") {
  const Scratch folder;
  for (const std::string file : {"none.csv", "../none.mat", ".", "/dev/zero", "pipe.csv"}) {
    folder.file("a.yaml", from_file(file));
    std::filesystem::remove(folder.path("pipe.csv"));
    if (file == "pipe.csv") REQUIRE(std::system(("mkfifo " + folder.path("pipe.csv")).c_str()) == 0);
    const Done done = run_program(folder, {"check", "a.yaml"});
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK(done.seconds < 5.0);
    CHECK_THAT(done.err, Catch::StartsWith("a.yaml:6:34: press.file: "));
  }
}
