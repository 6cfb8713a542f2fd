#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "tests/engine/app/cli/program.hpp"

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
  full.max_bytes_of_file = 2000;
  const Done done = run_program(folder, full);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("out/signals.csv: "));
  CHECK(content_of(folder.path("out/signals.csv")) == "of the run before\n");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out")))
    CHECK(entry.path().extension() != ".part");
}

TEST_CASE("an HDF5 file for which there is no room ends the call with 3, and with one line") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  Call full = call({"run", "lag.yaml", "--out", "out", "--files", "h5"});
  full.max_bytes_of_file = 2000;
  const Done done = run_program(folder, full);
  CHECK(done.code == 3);
  CHECK(done.err == "out/signals.h5: File too large\n");
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

TEST_CASE("a reader who has left is no fault, and an output that is closed is one line and 3") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  Call left = call({"run", "lag.yaml", "--out", "out"});
  left.closed_pipe = true;
  Done done = run_program(folder, left);
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(content_of(folder.path("out/figure.svg")), Contains("</svg>"));
  Call closed = call({"run", "lag.yaml"});
  closed.closed = {STDOUT_FILENO};
  done = run_program(folder, closed);
  CHECK(done.code == 3);
  CHECK(lines_of(done.err).size() == 1);
}

TEST_CASE("where the standard error takes nothing the exit code still says what happened") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("wrong.yaml", "stepwire: 1\nblocks: 3\n");
  for (const bool closed : {false, true}) {
    const auto code = [&](const std::vector<std::string>& arguments) {
      Call quiet = call(arguments);
      if (closed) quiet.closed = {STDERR_FILENO};
      quiet.err_to = "/dev/full";
      return run_program(folder, quiet).code;
    };
    CHECK(code({"run", "lag.yaml"}) == 0);
    CHECK(code({"run", "wrong.yaml"}) == 2);
    CHECK(code({"run", "none.yaml"}) == 2);
    CHECK(code({"no-verb"}) == 2);
    CHECK(code({"run", "lag.yaml", "--out", "/proc/nowhere"}) == 3);
  }
}

TEST_CASE("a thread that cannot be begun costs time, or ends with 3 and a line") {
  const Scratch folder;
  folder.file("sweep.yaml", lag_yaml + "sweep: {tau: {from: 0.05 s, to: 0.1 s, count: 20}}\n");
  Call alone = call({"run", "sweep.yaml", "--out", "out"});
  alone.no_threads = true;
  Done done = run_program(folder, alone);
  INFO(done.err);
  CHECK(done.code == 0);
  alone.arguments = {"loop", "sweep.yaml", "--duration", "0.1", "--policy", "other"};
  done = run_program(folder, alone);
  CHECK(done.code == 3);
  CHECK(lines_of(done.err).size() == 1);
}

TEST_CASE("without the database of units every call ends with 3 and a line") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "lag.yaml"}, {"blocks"}, {"schema"}, {"loop", "lag.yaml"}}) {
    Call bare = call(arguments);
    bare.environment["UDUNITS2_XML_PATH"] = folder.path("none.xml");
    const Done done = run_program(folder, bare);
    INFO(done.err);
    CHECK((done.code == 3 || (done.code == 0 && done.err.empty())));
    CHECK((done.code == 0 || lines_of(done.err).size() == 1));
  }
  Call bare = call({"run", "lag.yaml"});
  bare.environment["UDUNITS2_XML_PATH"] = folder.path("none.xml");
  CHECK_THAT(run_program(folder, bare).err, Contains("unit database"));
}

TEST_CASE("a pipe, a device or a folder in the place of a diagram file is refused at once with 2") {
  const Scratch folder;
  REQUIRE(::mkfifo(folder.path("pipe.yaml").c_str(), 0600) == 0);
  for (const std::string verb : {"run", "check", "draw", "flatten", "loop", "fit", "study"})
    for (const std::string file : {"pipe.yaml", "/dev/zero", "/dev/tty", "."}) {
      const Done done = run_program(folder, {verb, file});
      INFO(verb << " " << file << ": " << done.err);
      CHECK(done.code == 2);
      CHECK(done.seconds < 5.0);
      CHECK(lines_of(done.err).size() == 1);
    }
}

TEST_CASE("a pipe that nobody reads is no place for a result") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  const Done done = run_program(folder, {"flatten", "lag.yaml", "-o", "pipe"});
  CHECK(done.code == 3);
  CHECK(done.seconds < 5.0);
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
