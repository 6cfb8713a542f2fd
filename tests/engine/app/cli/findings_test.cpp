// Findings about pictures after a run: panels that select nothing.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A sweep of three gains, with a figure of these keys.
std::string swept(const std::string& figure) {
  return "stepwire: 1\nstep: 10 ms\nstop: 0.1 s\nsolver: rk4\nparameters: {k: 1}\nsweep: {k: [1, 2, 4]}\n"
         "blocks:\n  push: {block: Gain, u: lag, gain: -1}\n  lag: {block: Lag, u: 1, tau: 0.1 s}\n"
         "  more: {block: Gain, u: lag, gain: $k}\nrecord: [more, push]\n"
         "linear: {loop: {from: push, to: push, open: push}}\nfigure: " +
         figure + "\n";
}

Done run_with(const Scratch& folder, const std::string& figure) {
  folder.file("sweep.yaml", swept(figure));
  return run_program(folder, {"run", "sweep.yaml", "--out", "out"});
}

}  // namespace

TEST_CASE("a panel that selects no row is a finding, with the values among which it selects") {
  const Scratch folder;
  const std::string lines = "{plot: lines, x: time in s, y: more, where: k == 3}";
  const Done done = run_with(folder, lines);
  CHECK(done.code == 0);
  CHECK_THAT(done.out,
             Contains("  note figure: 'k == 3' selects none of 33 rows (3 runs), in which k is 1, 2 or 4\n"));
  const auto json = nlohmann::json::parse(content_of(folder.path("out/run.json")));
  REQUIRE(json["findings"].size() == 1);
  CHECK_THAT(json["findings"][0].get<std::string>(), Contains("selects none of 33 rows"));
}

TEST_CASE("each kind of panel with a condition has the finding, and none that selects something") {
  const Scratch folder;
  for (const std::string panel :
       {"plot: lines, x: time in s, y: more", "plot: xy, x: time in s, y: more, boundary: y - 1",
        "plot: loop, x: more, y: push", "plot: bode, of: loop", "plot: nyquist, of: loop",
        "plot: step_response, of: loop", "plot: poles, of: loop", "plot: histogram, x: more"}) {
    INFO(panel);
    CHECK_THAT(run_with(folder, "{" + panel + ", where: k > 4}").out,
               Contains("note figure") && Contains("'k > 4' selects none of ") && Contains("k is 1, 2 or 4"));
    CHECK_THAT(run_with(folder, "{" + panel + ", where: k > 2}").out, !Contains("selects none"));
  }
  CHECK_THAT(
      run_with(folder,
               "[{plot: lines, x: time in s, y: more}, {panels: [{plot: lines, x: time in s, y: "
               "push}, {plot: lines, title: Late, x: time in s, y: more, where: time > 1 s}]}]")
          .out,
      Contains("note figure 2, panel 2, 'Late': 'time > 1 s' selects none of 33 rows (3 runs), in which "
               "time is from 0 to 0.1 s\n"));
}
