// Folders of parts that a call names, and suggestions for misspelt words of a call.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

const std::string user = R"(stepwire: 1
solver: rk4
step: 1 ms
stop: 5 ms
sweep: {level: [1, 2]}
parameters: {level: 1}
blocks:
  rig: {diagram: rig.yaml, level: $level}
record: [rig.y]
)";
const std::string rig = R"(stepwire: 1
parameters: {level: 1}
outputs: {y: lag}
blocks:
  lag: {block: Lag, u: $level, tau: 10 ms}
)";

/// A diagram with a part in another folder.
struct Apart : Scratch {
  Apart() {
    std::filesystem::create_directories(path("shelf"));
    file("main.yaml", user);
    file("shelf/rig.yaml", rig);
  }
};

/// Names of all verbs, as the completion of bash lists them.
std::vector<std::string> all_verbs() {
  std::vector<std::string> verbs;
  const std::string text = run_program(Scratch(), {"completion", "fish"}).out;
  const std::string begin = "complete -c stepwire -n __fish_use_subcommand -f -a ";
  for (const std::string& line : lines_of(text))
    if (line.starts_with(begin))
      verbs.push_back(line.substr(begin.size(), line.find(' ', begin.size()) - begin.size()));
  return verbs;
}

}  // namespace

TEST_CASE("every verb takes folders of parts, so that each that opens a diagram finds its parts") {
  const Scratch folder;
  const auto verbs = all_verbs();
  REQUIRE(verbs.size() > 20);
  for (const std::string& verb : verbs) {
    INFO(verb);
    CHECK_THAT(run_program(folder, {verb, "--help"}).out, Contains("--parts DIR"));
  }
}

TEST_CASE("verbs find parts in the folder that the call names, before or after the verb") {
  const Apart folder;
  const auto works = [&](std::vector<std::string> words) {
    const Done lost = run_program(folder, words);
    INFO(words.front() + ": " + lost.err);
    CHECK(lost.code != 0);
    words.insert(words.end(), {"--parts", "shelf"});
    const Done found = run_program(folder, words);
    INFO(found.err);
    CHECK(found.code == 0);
  };
  works({"run", "main.yaml", "--out", "out"});
  works({"check", "main.yaml"});
  works({"draw", "main.yaml", "-o", "main.svg"});
  works({"flatten", "main.yaml", "-o", "flat.yaml"});
  works({"generate", "main.yaml", "--out", "code"});
  works({"run", "main.yaml", "--part", "1/1", "--out", "share"});
  works({"job", "main.yaml", "--tasks", "2", "--script", "job.sh"});
  CHECK_THAT(content_of(folder.path("job.sh")), Contains(" --parts shelf\n"));
  CHECK(run_program(folder, {"--parts", "shelf", "check", "main.yaml"}).code == 0);
  CHECK(run_program(folder, {"collect", "share", "--out", "all", "--parts", "shelf"}).code == 0);
  CHECK(run_program(folder, {"verify", "out", "--parts", "shelf"}).code == 0);
}

TEST_CASE("a folder of parts that is not there is refused") {
  const Apart folder;
  const Done refused = run_program(folder, {"check", "main.yaml", "--parts", "shelv"});
  CHECK(refused.code == 2);
  CHECK(refused.err == "--parts shelv: no such folder\n");
}

TEST_CASE("misspelt words of a call are refused with the nearest word") {
  const Apart folder;
  const auto meant = [&](const std::vector<std::string>& words, const std::string& word) {
    const Done refused = run_program(folder, words);
    INFO(refused.err);
    CHECK(refused.code != 0);
    CHECK_THAT(refused.err, Contains("did you mean '" + word + "'?"));
  };
  meant({"chekc", "main.yaml"}, "check");
  meant({"run", "main.yaml", "--stp=3s"}, "--stop");
  meant({"--quite", "run", "main.yaml"}, "--quiet");
  meant({"run", "main.yaml", "--engine", "compild"}, "compiled");
  meant({"run", "main.yaml", "--color", "alway"}, "always");
  meant({"run", "main.yaml", "--files", "cvs", "--out", "o"}, "csv");
  meant({"run", "main.yaml", "--pictures", "pgn", "--out", "o"}, "png");
  meant({"completion", "bsh"}, "bash");
  meant({"run", "mian.yaml"}, "main.yaml");
  meant({"blocks", "shelf/rgi.yaml"}, "shelf/rig.yaml");
  meant({"blocks", "temprature"}, "temperature");
  meant({"blocks", "Intergrator"}, "Integrator");
  meant({"blocks", "stepwire/oscilator"}, "stepwire/oscillator");
  meant({"format", "figur"}, "figure");
  meant({"help", "rnu"}, "run");
}

TEST_CASE("blocks explains a part by its name, and searches for the words of a name that is none") {
  const Apart folder;
  CHECK_THAT(run_program(folder, {"blocks", "stepwire/oscillator"}).out, Contains("oscillator"));
  CHECK_THAT(run_program(folder, {"blocks", "rig.yaml", "--parts", "shelf"}).out, Contains("level"));
  const Done table = run_program(folder, {"blocks", "MyLookup"});
  CHECK(table.code == 0);
  CHECK_THAT(table.out,
             Contains("there is no block 'MyLookup'; blocks about 'Lookup' are:") && Contains("LookupTable"));
}
