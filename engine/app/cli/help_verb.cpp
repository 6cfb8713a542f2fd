#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/call_words.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/man_page.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

struct HelpCall {
  std::string verb;  ///< empty: help of the program
  bool man = false;
};

ExitCode show_help(const HelpCall& call, const CLI::App& program) {
  if (call.man) {
    put_data(man_page(program_words(program), verb_words(program)));
    return ExitCode::done;
  }
  std::vector<std::string> names;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == call.verb) {
      put_data(verb->help(program.get_name()));
      return ExitCode::done;
    }
    names.push_back(verb->get_name());
  }
  if (call.verb.empty()) {
    put_data(program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal));
    return ExitCode::done;
  }
  complain("there is no verb '{}'{}\n", text::visible(call.verb),
           yaml::did_you_mean(call.verb, names, "'stepwire help' lists them").text());
  return ExitCode::wrong;
}

Action declare_help(CLI::App& verb) {
  const auto call = std::make_shared<HelpCall>();
  verb.add_option("VERB", call->verb, "a verb; without it the program's own help");
  verb.add_flag("--man", call->man, "the manual page of all verbs, for man");
  return [call, program = verb.get_parent()](const Registry&) { return show_help(*call, *program); };
}

}  // namespace

Verb help_verb() {
  return {"help", "explain a verb, as VERB --help does",
          "Example:\n  stepwire help run\n  stepwire help --man | man -l -", declare_help};
}

}  // namespace stepwire::cli
