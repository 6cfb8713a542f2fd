#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;

namespace {

std::string carrying_study() {
  return content_of(STEPWIRE_SOURCE_DIR "/diagrams/examples/83-what-is-carried.yaml");
}

/// The same without what is drawn and claimed.
std::string bare() {
  const std::string text = carrying_study();
  return text.substr(0, text.find("figure:\n"));
}

nlohmann::json trials_of(const std::string& text, const std::vector<std::string>& more = {}) {
  const Scratch folder;
  folder.file("a.yaml", text);
  std::vector<std::string> call{"study", "a.yaml", "--out", "out"};
  call.insert(call.end(), more.begin(), more.end());
  const Done done = run_program(folder, {call});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  return json_file(folder, "out/study.json")["trials"];
}

std::string error_of(const std::string& text) {
  const Scratch folder;
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  return done.err;
}

double carried(const nlohmann::json& trial) {
  return trial["sets"].contains("learnt") ? std::stod(trial["sets"]["learnt"].get<std::string>()) : 0.0;
}

}  // namespace

TEST_CASE("each trial of a person begins with what the one before it has left") {
  // dy/dt = (1 - y)/8 s over trials of 2.52 s, of which the first is practice: y = 1 - exp(-n 2.52/8).
  for (const auto& trial : trials_of(bare())) {
    const double before = trial["order"].get<double>();
    CHECK(carried(trial) == Approx(1.0 - std::exp(-before * 2.52 / 8.0)).epsilon(1e-6));
  }
  for (const auto& trial : trials_of(replaced(bare(), "  practice: [HV]\n", ""))) {
    const double before = trial["order"].get<double>() - 1.0;
    CHECK(carried(trial) == Approx(1.0 - std::exp(-before * 2.52 / 8.0)).epsilon(1e-6));
    CHECK(trial["sets"].contains("learnt") == (before > 0.0));
  }
}

TEST_CASE(
    "what is carried has the same bits at any number of threads, compiled or not, and can be replayed") {
  const Scratch folder;
  folder.file("a.yaml", carrying_study());
  REQUIRE(
      run_program(folder, {"study", "a.yaml", "--threads", "1", "--engine", "interpreted", "--out", "one"})
          .code == 0);
  REQUIRE(run_program(folder, {"study", "a.yaml", "--threads", "4", "--engine", "compiled", "--out", "four"})
              .code == 0);
  for (const char* name : {"/trials.csv", "/errors.csv", "/signals.csv", "/tables.txt"}) {
    INFO(name);
    CHECK(content_of(folder.path("one") + name) == content_of(folder.path("four") + name));
  }
  const auto run = json_file(folder, "four/run.json");
  CHECK(run["compiled_ticks"] == run["ticks"]);
  CHECK(run_program(folder, {"verify", "four"}).code == 0);
  CHECK_THAT(lines_of(content_of(folder.path("one/trials.csv"))).front(), Contains(",order,learnt"));
  CHECK(run_program(folder, {"study", "a.yaml", "--trials", "one/trials.csv"}).code != 2);
}

TEST_CASE("the value with which a person begins is swept, although it is carried from then on") {
  const Scratch folder;
  folder.file("a.yaml", replaced(replaced(bare(), "  practice: [HV]\n", ""), "study:\n",
                                 "sweep: {learnt: [0, 0.5]}\nstudy:\n"));
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto lines = lines_of(content_of(folder.path("out/errors.csv")));
  CHECK_THAT(lines.front(), Contains("learnt,") && Contains(",order,carried.learnt"));
  const auto points = json_file(folder, "out/study.json")["points"];
  REQUIRE(points.size() == 2);
  // dy/dt = (1 - y)/8 s over trials of 2.52 s, from 0.5.
  for (const auto& trial : points[1]["trials"]) {
    const double before = trial["order"].get<double>() - 1.0;
    if (before > 0.0)
      CHECK(carried(trial) == Approx(1.0 - 0.5 * std::exp(-before * 2.52 / 8.0)).epsilon(1e-6));
  }
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a list is carried, in the unit of its signal") {
  const std::string text =
      replaced(replaced(replaced(bare(), "carry: {learnt: skill}", "carry: {learnt: skill, place: hand}"),
                        "  pace:", "  place: {value: [0 mm, 0 mm], doc: of the pen}\n  pace:"),
               "blocks:\n", "blocks:\n  was: {block: Constant, value: $place}\n");
  for (const auto& trial : trials_of(text)) {
    const auto place = trial["sets"]["place"].get<std::string>();
    // The pen rests where a turn ends: one radius beside the centre.
    CHECK_THAT(place, Catch::StartsWith("[0.0") && Contains(" m, ") && Catch::EndsWith(" m]"));
  }
}

TEST_CASE("conditions that `order` lists come first, and the others in an order of each person's own") {
  const auto trials = trials_of(replaced(bare(), "order: [NO]", "order: [NO, HV]"));
  for (const auto& trial : trials) {
    if (trial["condition"] == "NO") CHECK(trial["order"] == 1);
    if (trial["condition"] == "HV") CHECK(trial["order"] == 2);
    if (trial["condition"] == "V") CHECK(trial["order"].get<int>() >= 3);
  }
}

TEST_CASE("practice from which nothing is carried changes nothing") {
  const std::string nothing = replaced(bare(), "  carry: {learnt: skill}\n", "");
  const std::string used = replaced(nothing, "  learnt:  {value: 0,", "  learnt:  {value: 0.1,");
  CHECK(trials_of(used) == trials_of(replaced(used, "  practice: [HV]\n", "")));
}

TEST_CASE("a trial that is repeated begins again with what was carried into it") {
  // Most first attempts do not end in time: the noise has to be above a limit within them.
  const std::string text =
      replaced(replaced(bare(), "stop_when: turned > 6.2832", "stop_when: turned > 6.2832 && noise > 0"),
               "stop: 4 s", "stop: 2.53 s");
  int repeated = 0;
  for (const auto& trial : trials_of(text)) {
    repeated += trial["attempts"].get<int>() > 1;
    CHECK(carried(trial) == Approx(1.0 - std::exp(-trial["order"].get<double>() * 2.52 / 8.0)).epsilon(0.01));
  }
  CHECK(repeated > 3);
}

TEST_CASE("values are carried at each point of a sweep, and in each experiment") {
  const Scratch folder;
  folder.file("a.yaml", replaced(bare(), "study:\n", "sweep: {pace: [8 s, 4 s]}\nstudy:\n"));
  const Done done = run_program(folder, {"study", "a.yaml", "--repeat", "2", "--out", "out"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto points = json_file(folder, "out/study.json")["points"];
  for (const auto& [point, pace] : {std::pair{0, 8.0}, std::pair{1, 4.0}})
    for (const auto& trial : points[point]["trials"])
      CHECK(carried(trial) ==
            Approx(1.0 - std::exp(-trial["order"].get<double>() * 2.52 / pace)).epsilon(1e-6));
  CHECK(points[0]["experiments"].size() == 2);
}

TEST_CASE("what cannot follow from trial to trial is refused in words") {
  const auto carrying = [](const std::string& what) {
    return replaced(bare(), "carry: {learnt: skill}", "carry: " + what);
  };
  CHECK_THAT(error_of(carrying("{learn: skill}")),
             Contains("no parameter 'learn' of numbers; did you mean 'learnt'?"));
  CHECK_THAT(error_of(carrying("{learnt: skil}")), Contains("no signal 'skil'; did you mean 'skill'?"));
  CHECK_THAT(error_of(carrying("{seed: skill}")), Contains("the study sets 'seed' for each trial"));
  CHECK_THAT(error_of(carrying("{visual: skill}")), Contains("the study sets 'visual' for each trial"));
  CHECK_THAT(error_of(carrying("{pace: far}")),
             Contains("'far' is in m, but the parameter is in s; give that a value in m"));
  CHECK_THAT(error_of(carrying("{learnt: hand}")), Contains("'hand' has 2 elements, and the parameter 1"));
  CHECK_THAT(error_of(carrying("learnt")), Contains("is a map of parameters and signals"));
  CHECK_THAT(error_of(replaced(bare(), "order: [NO]", "order: [HV]")),
             Contains("'NO' comes first, since the circle of the others is fitted to it"));
  CHECK_THAT(error_of(replaced(bare(), "order: [NO]", "order: [NO, NO]")),
             Contains("'NO' stands here twice"));
  CHECK_THAT(error_of(replaced(bare(), "practice: [HV]", "practice: [VH]")),
             Contains("there is no condition 'VH'"));
}
