#include "engine/app/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "engine/app/cli/blockset_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/guarded.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

namespace {

/// All verbs with what they fill in.
class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.failure_message([](const CLI::App*, const CLI::Error& error) {
      return fmt::format("stepwire: {}; stepwire --help and stepwire VERB --help tell more\n",
                         visible(error.what()));
    });
    app_.set_version_flag("--version", "stepwire " + program_version());
    for (const Verb& verb : verbs()) {
      CLI::App* words = app_.add_subcommand(verb.name, verb.about);
      words->footer(verb.footer);
      words->callback([this, action = verb.declare(*words)] { action_ = action; });
    }
    blocksets_.add_to(app_);
  }

  ExitCode run(int argc, char** argv, Registry registry) {
    if (argc > 1 && *argv[1] != '-' && !is_verb(argv[1])) return refuse_verb(argv[1]);
    try {
      app_.parse(argc, argv);
      blocksets_.load(registry);
      return action_(registry);
    } catch (const CLI::ParseError& error) {
      return explain(error);
    }
  }

 private:
  /// Prints the help of --help, or what is wrong in the call.
  ExitCode explain(const CLI::ParseError& error) const {
    std::ostringstream help, wrong;
    const int code = app_.exit(error, help, wrong);
    put_text(help.str());
    put_trouble(wrong.str());
    return code == 0 ? ExitCode::done : ExitCode::wrong;
  }

  static bool is_verb(const std::string& word) {
    return std::ranges::any_of(verbs(), [&](const Verb& verb) { return word == verb.name; });
  }

  static ExitCode refuse_verb(const std::string& word) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs()) names.emplace_back(verb.name);
    complain("stepwire: there is no '{}'{}\n", visible(word),
             did_you_mean(word, names, fmt::format("There are: {}", fmt::join(names, ", "))));
    return ExitCode::wrong;
  }

  CLI::App app_{"Block diagrams in text, run at a fixed step."};
  BlocksetOptions blocksets_;
  Action action_;
};

}  // namespace

int run_command_line(int argc, char** argv, Registry (*blocks)()) {
  fill_standard_streams();
  catch_signals();
  const ExitCode code = guarded([&] { return CommandLine().run(argc, argv, blocks()); });
  if (const std::string problem = take_cache_problem(); !problem.empty())
    complain("the cache keeps nothing: {}\n", visible(problem));
  return static_cast<int>(finish_output() ? code : worst(code, ExitCode::surroundings));
}

}  // namespace stepwire
