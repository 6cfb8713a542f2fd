#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

const std::string limited_lag =
    "stepwire: 1\ntitle: A lag <follows> a step\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nparameters:\n"
    "  level: {value: 2 N, above: 0 N, at_most: 5 N, doc: of the step}\nblocks:\n"
    "  lag: {block: Lag, u: $level, tau: 0.1 s}\nrecord: [lag]\n"
    "claims:\n  - {that: it arrives, final: lag, equals: 2 N, within: 1 %}\n";

}  // namespace

TEST_CASE("report writes one page with parameters, limits, claims, coverage and versions, without links") {
  const Scratch folder;
  folder.file("lag.yaml", limited_lag);
  const Done done = run_program(folder, {"report", "lag.yaml", "-o", "lag.html"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  const std::string page = content_of(folder.path("lag.html"));
  CHECK_THAT(page, Contains("A lag &lt;follows&gt; a step") && Contains("above 0 N, at_most 5 N") &&
                       Contains("of the step") && Contains("it arrives") && Contains("1 claim holds") &&
                       Contains("No block has a condition") && Contains("hash of the flattened diagram"));
  CHECK_THAT(page, !Contains("<script") && !Contains("<link rel=\"stylesheet\""));
}

TEST_CASE("report of a folder has all of its diagrams, and the exit code of the worst") {
  const Scratch folder;
  std::filesystem::create_directories(folder.path("models"));
  folder.file("models/a.yaml", limited_lag);
  folder.file("models/b.yaml", limited_lag + "  - {that: it is above, final: lag, at_least: 3 N}\n");
  folder.file("models/part.yaml",
              "stepwire: 1\ninputs: {x: {unit: N}}\noutputs: {y: gain}\nblocks:\n"
              "  gain: {block: Gain, u: x, gain: 2}\n");
  const Done done = run_program(folder, {"report", "models", "-o", "all.html"});
  INFO(done.out << done.err);
  CHECK(done.code == 1);
  CHECK_THAT(content_of(folder.path("all.html")), Contains("href=\"#model-2\"") && Contains("it is above"));
  folder.file("models/c.yaml", "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  x: {block: Nothing}\n");
  CHECK(run_program(folder, {"report", "models", "-o", "all.html"}).code == 2);
}

TEST_CASE("report --pdf prints the page, or says what is missing") {
  const Scratch folder;
  folder.file("lag.yaml", limited_lag);
  const Done none = run_program(folder, {{"report", "lag.yaml", "-o", "lag.html", "--pdf", "lag.pdf"},
                                         {{"PATH", folder.path("empty")}}});
  CHECK(none.code == 3);
  CHECK_THAT(none.err, Contains("chromium is not installed"));
  CHECK_THAT(content_of(folder.path("lag.html")), Contains("There is no drawing"));
  if (stepwire::subprocess::find_program("chromium").empty()) return;
  const Done done = run_program(folder, {"report", "lag.yaml", "-o", "lag.html", "--pdf", "lag.pdf"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK(content_of(folder.path("lag.pdf")).starts_with("%PDF"));
}

TEST_CASE("report writes the format that the name says, and refuses other names before it runs") {
  const Scratch folder;
  folder.file("lag.yaml", limited_lag);
  const Done other = run_program(folder, {"report", "lag.yaml", "-o", "lag.txt"});
  CHECK(other.code == 2);
  CHECK(other.err == "lag.txt: a page is a .html or .pdf file\n");
  CHECK(run_program(folder, {"report", "lag.yaml", "--pdf", "lag.html"}).code == 2);
  CHECK(!std::filesystem::exists(folder.path("lag.html")));
  if (stepwire::subprocess::find_program("chromium").empty()) return;
  CHECK(run_program(folder, {"report", "lag.yaml", "-o", "lag.pdf"}).code == 0);
  CHECK(content_of(folder.path("lag.pdf")).starts_with("%PDF"));
}
