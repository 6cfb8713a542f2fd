// Results on the standard output: a table, an archive, and readers who leave.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

namespace fs = std::filesystem;

Scratch& with_lag(Scratch& folder) {
  folder.file("lag.yaml", lag_yaml);
  return folder;
}

/// Of a line of a POSIX shell in the folder, in which $S is the program.
int run_line(const Scratch& folder, const std::string& line) {
  folder.file("line.sh", "S='" STEPWIRE_PROGRAM "'\ncd " + folder.path("") + "\n" + line + "\n");
  return WEXITSTATUS(std::system(("bash " + folder.path("line.sh")).c_str()));
}

}  // namespace

TEST_CASE("the call --csv - gives the bytes of signals.csv, and words for people on the standard error") {
  Scratch folder;
  with_lag(folder);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  const Done done = run_program(folder, {"run", "lag.yaml", "--csv", "-"});
  CHECK(done.code == 0);
  CHECK(done.out == content_of(folder.path("out/signals.csv")));
  CHECK_THAT(done.err, Contains("  ok "));
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--csv", "table.csv"}).code == 0);
  CHECK(content_of(folder.path("table.csv")) == done.out);
}

TEST_CASE("the call --out - gives a tar archive of what --out writes, in a folder of the diagram's name") {
  Scratch folder;
  with_lag(folder).file("other.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  CHECK(run_line(folder, "$S run lag.yaml other.yaml --out - 2>words | tar x") == 0);
  CHECK_THAT(content_of(folder.path("words")), Contains("  ok "));
  for (const auto& entry : fs::directory_iterator(folder.path("out")))
    CHECK(fs::exists(folder.path("other/" + entry.path().filename().string())));
  CHECK(content_of(folder.path("lag/signals.csv")) == content_of(folder.path("out/signals.csv")));
  CHECK(run_program(folder, {"verify", "lag"}).code == 0);
}

TEST_CASE("a reader who leaves early, as head does, is no fault and no line") {
  Scratch folder;
  with_lag(folder);
  for (const std::string kind : {"--csv", "--out"}) {
    CHECK(run_line(folder, "$S run lag.yaml --stop 20s --quiet " + kind +
                               " - 2>words | head -c 10 >head; exit ${PIPESTATUS[0]}") == 0);
    CHECK(content_of(folder.path("words")).empty());
    CHECK(content_of(folder.path("head")).size() == 10);
  }
}

TEST_CASE("what one standard output cannot hold is refused with a sentence, and nothing is run") {
  Scratch folder;
  with_lag(folder).file("other.yaml", lag_yaml);
  folder.file("two.yaml", lag_yaml.substr(0, lag_yaml.find("record:")) +
                              "record:\n  - {signals: [lag]}\n  - {signals: [lag], every: 10 ms}\n");
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    const Done done = run_program(folder, arguments);
    CHECK(done.code == 2);
    CHECK(done.out.empty());
    CHECK(lines_of(done.err).size() == 1);
    return done.err;
  };
  CHECK_THAT(refusal({"run", "lag.yaml", "--csv", "-", "--json"}), Contains("--json and --csv - would mix"));
  CHECK_THAT(refusal({"run", "lag.yaml", "--csv", "-", "--out", "-"}),
             Contains("--csv - and --out - would mix"));
  CHECK_THAT(refusal({"run", "lag.yaml", "other.yaml", "--csv", "-"}), Contains("--csv is a single table"));
  CHECK_THAT(refusal({"run", "two.yaml", "--csv", "-"}),
             Contains("two.yaml: ") && Contains("records at 2 periods"));
}
