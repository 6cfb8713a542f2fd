#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

std::string sweep_yaml() {
  return lag_yaml + "sweep: {tau: {from: 10 ms, to: 120 ms, count: 12}}\n";
}

/// Files of a folder of results that are the same whatever ran the points: all but times of the machine.
const std::vector<std::string> same_files{"signals.csv", "signals.mat", "claims.json", "sweep.csv",
                                          "diagram.yaml"};

void check_same(const Scratch& folder, const std::string& a, const std::string& b) {
  for (const std::string& file : same_files) {
    INFO(a << "/" << file << " and that of " << b);
    const std::string content = content_of(folder.path(a + "/" + file));
    CHECK_FALSE(content.empty());
    CHECK(content == content_of(folder.path(b + "/" + file)));
  }
}

Done shares_of_three(const Scratch& folder, const std::string& numbers) {
  Done done;
  for (const char number : numbers) {
    const std::string share(1, number);
    done = run_program(folder, {"run", "sweep.yaml", "--part", share + "/3", "--out", "part-" + share});
    INFO(done.err);
    REQUIRE(done.code == 0);
  }
  return done;
}

}  // namespace

TEST_CASE("shares of a sweep are joined to the bytes of one run, in any order and one twice") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_yaml());
  REQUIRE(run_program(folder, {"run", "sweep.yaml", "--out", "whole"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("whole/points.journal")));
  CHECK_THAT(shares_of_three(folder, "213").out, Contains("share 3 of 3, 4 of 12 points"));
  const Done done = run_program(folder, {"collect", "part-3", "part-1", "part-2", "part-3", "--out", "all"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("12 runs"));
  check_same(folder, "whole", "all");
  CHECK(run_program(folder, {"verify", "all"}).code == 0);
}

TEST_CASE("a share that is missing is named by its points, and nothing is written") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_yaml());
  shares_of_three(folder, "13");
  const Done done = run_program(folder, {"collect", "part-1", "part-3", "--out", "all"});
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("of 12 points these are missing: 5 to 8;"));
  CHECK_FALSE(std::filesystem::exists(folder.path("all")));
}

TEST_CASE("shares of another state of the file, or of other settings, are refused") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_yaml());
  shares_of_three(folder, "12");
  REQUIRE(run_program(folder, {"run", "sweep.yaml", "--part", "3/3", "--out", "part-3", "--stop", "0.4 s"})
              .code == 0);
  Done done = run_program(folder, {"collect", "part-1", "part-2", "part-3"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err,
             Contains("part-3/points.journal") && Contains("has points of another sweep than part-1"));
  folder.file("sweep.yaml", sweep_yaml() + "# a comment changes nothing\n");
  CHECK(run_program(folder, {"collect", "part-1", "part-2"}).code == 3);
  folder.file("sweep.yaml", lag_yaml + "sweep: {tau: {from: 10 ms, to: 130 ms, count: 12}}\n");
  done = run_program(folder, {"collect", "part-1", "part-2"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("points of another state of sweep.yaml"));
  done = run_program(folder, {"collect", "."});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("is no file of points; 'run FILE --part K/N --out DIR' writes it"));
}

TEST_CASE("a share is K/N, of a sweep, in a folder") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_yaml());
  folder.file("lag.yaml", lag_yaml);
  for (const std::string part : {"0/3", "4/3", "1", "1/", "/3", "1/3x", "-1/3", "a/b"}) {
    const Done done = run_program(folder, {"run", "sweep.yaml", "--part", part, "--out", "x"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("is K/N, the share K of N"));
  }
  CHECK_THAT(run_program(folder, {"run", "lag.yaml", "--part", "1/2", "--out", "x"}).err,
             Contains("--part: needs a file with a section 'sweep'"));
  CHECK_THAT(run_program(folder, {"run", "sweep.yaml", "--part", "1/2"}).err, Contains("needs --out DIR"));
  CHECK_FALSE(std::filesystem::exists(folder.path("x")));
}

TEST_CASE("a sweep that was killed goes on behind the points that are kept, to the same bytes") {
  const Scratch folder;
  folder.file("slow.yaml", endless_yaml + "sweep: {lag.tau: {from: 0.1 s, to: 0.2 s, count: 40}}\n");
  const std::vector<std::string> words{"run", "slow.yaml", "--stop", "60 s", "--engine", "interpreted"};
  const auto with = [&](const std::string& out) {
    Call call;
    call.arguments = words;
    call.arguments.insert(call.arguments.end(), {"--out", out});
    return call;
  };
  REQUIRE(run_program(folder, with("whole")).code == 0);
  Call killed = with("kept");
  killed.interrupt_after = 0.7;
  killed.signals = {SIGKILL};
  run_program(folder, killed);
  const Done done = run_program(folder, with("kept"));
  INFO(done.err);
  CHECK(done.code == 0);
  check_same(folder, "whole", "kept");
  CHECK_FALSE(std::filesystem::exists(folder.path("kept/points.journal")));
}

TEST_CASE("the script for a cluster runs the shares, whatever its files are called") {
  const Scratch folder;
  const std::string name = "a sweep's; $(touch oops).yaml";
  folder.file(name, sweep_yaml());
  const Done done = run_program(
      folder, {"job", name, "--tasks", "2", "--out", "o ut", "--script", "job.sh", "--stop", "0.3 s"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK_THAT(content_of(folder.path("job.sh")), Contains("#SBATCH --array=1-2\n"));
  for (const std::string task : {"1", "2"}) {
    const auto ran = stepwire::subprocess::run_process(
        {.command = {"env", "SLURM_ARRAY_TASK_ID=" + task, "sh", folder.path("job.sh")}});
    INFO(ran.errors);
    REQUIRE(ran.succeeded());
  }
  CHECK_FALSE(std::filesystem::exists(folder.path("oops")));
  CHECK(run_program(folder, {"collect", "o ut/part-1", "o ut/part-2"}).code == 0);
}

TEST_CASE("a script for PBS has its words, and tasks without points are refused") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_yaml());
  CHECK_THAT(run_program(folder, {"job", "sweep.yaml", "--pbs", "--tasks", "12"}).out,
             Contains("#PBS -J 1-12\n") && Contains("$PBS_ARRAY_INDEX"));
  const Done done = run_program(folder, {"job", "sweep.yaml", "--tasks", "13"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("--tasks: must be from 1 to 12, the points of the sweep, not 13"));
}
