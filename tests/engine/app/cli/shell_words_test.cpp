#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

using namespace stepwire;
using Catch::Contains;

namespace {

std::string printed(const std::vector<std::string>& arguments) {
  const Done done = run_program(Scratch(), arguments);
  REQUIRE(done.code == 0);
  REQUIRE(done.err.empty());
  return done.out;
}

/// Returns the completions of bash for the last word of a call, in a folder with the file cart.yaml.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  const Scratch folder;
  folder.file("cart.yaml", lag_yaml);
  std::string script =
      printed({"completion", "bash"}) + "compopt() { :; }\ncd " + folder.path(".") + "\nCOMP_WORDS=(";
  for (const std::string& word : words) script += " '" + word + "'";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_stepwire\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const auto done = subprocess::run_process({.command = {"bash", "--norc", "-s"}, .input = script});
  INFO(done.errors);
  REQUIRE(done.succeeded());
  REQUIRE(done.errors.empty());
  return lines_of(done.output);
}

/// True if a shell accepts a script or is not installed.
bool is_accepted(const std::string& shell, const std::string& script) {
  if (subprocess::find_program(shell).empty()) {
    WARN(shell << " is not here; nothing was checked");
    return true;
  }
  const Scratch folder;
  folder.file("script", script);
  const auto done = subprocess::run_process({.command = {shell, "-n", folder.path("script")}});
  INFO(done.errors);
  return done.succeeded() && done.errors.empty();
}

}  // namespace

TEST_CASE("bash completes verbs, options, the words of an option, and files") {
  CHECK(offered({"stepwire", "li"}) == std::vector<std::string>{"linearize"});
  CHECK(offered({"stepwire", "run", "--se"}) == std::vector<std::string>{"--set", "--set-from"});
  CHECK(offered({"stepwire", "run", "--profile", "ca"}) == std::vector<std::string>{"cart.yaml"});
  CHECK(offered({"stepwire", "linearize", "--feedback", ""}) ==
        std::vector<std::string>{"negative", "positive"});
  CHECK(offered({"stepwire", "completion", ""}) == std::vector<std::string>{"bash", "zsh", "fish"});
}

TEST_CASE("every verb and option is in the completions of each shell and in the manual page") {
  const std::string bash = printed({"completion", "bash"}), zsh = printed({"completion", "zsh"}),
                    fish = printed({"completion", "fish"}), man = printed({"help", "--man"});
  for (const std::string& line : lines_of(printed({"help"}))) {
    if (!line.starts_with("  ") || line[2] < 'a' || line[2] > 'z') continue;
    const std::string verb = line.substr(2, line.find(' ', 2) - 2);
    INFO(verb);
    CHECK_THAT(bash, Contains("  " + verb + ")\n"));
    CHECK_THAT(zsh, Contains("    " + verb + ")\n"));
    CHECK_THAT(fish, Contains(" -f -a " + verb + " -d "));
    CHECK_THAT(man, Contains(".SS " + std::regex_replace(verb, std::regex("-"), "\\-") + "\n"));
  }
  CHECK_THAT(bash, Contains("--set-from"));
  CHECK_THAT(zsh, Contains("--set-from["));
  CHECK_THAT(fish, Contains("-l set-from"));
  CHECK_THAT(man, Contains("\\fB\\-\\-set\\-from\\fR"));
}

TEST_CASE("shells read their completions without a word, and roff the manual page") {
  for (const std::string shell : {"bash", "zsh", "fish"})
    CHECK(is_accepted(shell, printed({"completion", shell})));
  if (subprocess::find_program("groff").empty()) return;
  const auto done = subprocess::run_process(
      {.command = {"groff", "-man", "-Tutf8", "-ww", "-z"}, .input = printed({"help", "--man"})});
  CHECK(done.succeeded());
  CHECK(done.errors.empty());
}

TEST_CASE("help explains a verb as its own --help does, and refuses one that is none") {
  CHECK(printed({"help", "run"}) == printed({"run", "--help"}));
  CHECK(printed({"help"}) == printed({"--help"}));
  const Done done = run_program(Scratch(), {"help", "rnu"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("there is no verb 'rnu'; did you mean 'run'?"));
}

TEST_CASE("the version as JSON names the compiler and its flags") {
  const nlohmann::json version = nlohmann::json::parse(printed({"--version", "--json"}));
  CHECK(printed({"--version"}) == "stepwire " + version.at("version").get<std::string>() + "\n");
  CHECK_THAT(version.at("compiler").get<std::string>(), Contains("-ffp-contract=off"));
}
