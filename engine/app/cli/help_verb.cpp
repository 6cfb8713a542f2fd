#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/app/cli/call_words.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

/// Escapes requests, escapes and hyphens of roff.
std::string roff(std::string_view plain) {
  std::string text;
  bool begins = true;
  for (const char c : plain) {
    if (begins && (c == '.' || c == '\'')) text += "\\&";
    begins = c == '\n';
    if (c == '\\')
      text += "\\e";
    else if (c == '-')
      text += "\\-";
    else
      text += c;
  }
  return text;
}

std::string option_item(const OptionWords& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  std::string value =
      option.choices.empty() ? option.value : fmt::format("{}", fmt::join(option.choices, "|"));
  if (!value.empty() && option.names.front().starts_with('-'))
    names += fmt::format(" \\fI{}\\fR", roff(value));
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.about));
}

std::string synopsis(const VerbWords& verb) {
  std::string text = fmt::format("\\fBstepwire {}\\fR [\\fIOPTIONS\\fR]", roff(verb.name));
  for (const OptionWords& word : verb.positionals) {
    const std::string name =
        fmt::format("\\fI{}\\fR{}", roff(word.names.front()), word.repeated ? "..." : "");
    text += word.required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string section(const VerbWords& verb) {
  std::string text = fmt::format(".SS {}\n{}\n.PP\n{}\n", roff(verb.name), synopsis(verb), roff(verb.about));
  for (const OptionWords& word : verb.positionals) text += option_item(word);
  for (const OptionWords& option : verb.options) text += option_item(option);
  if (!verb.footer.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(verb.footer));
  return text;
}

/// Returns the manual page stepwire(1) as roff, generated from the declarations of the verbs.
std::string man_page(const VerbWords& program, const std::vector<VerbWords>& verbs) {
  std::string text = fmt::format(
      ".TH STEPWIRE 1 \"\" \"stepwire {}\" \"User Commands\"\n.SH NAME\nstepwire \\- run block diagrams that "
      "are "
      "written as text\n.SH SYNOPSIS\n\\fBstepwire\\fR [\\fIOPTIONS\\fR] \\fIVERB\\fR ...\n.SH "
      "DESCRIPTION\n{}\n"
      ".SH OPTIONS\n",
      session::program_version(), roff(program.about));
  for (const OptionWords& option : program.options) text += option_item(option);
  text += ".SH VERBS\n";
  for (const VerbWords& verb : verbs) text += section(verb);
  return text +
         ".SH EXIT STATUS\n.TP\n0\ndone, all claims hold\n.TP\n1\na claim fails, what is verified "
         "differs, or a search has not converged\n"
         ".TP\n2\nthe diagram or the call is wrong\n.TP\n3\nthe surroundings are: a full disk, a missing "
         "program "
         "or folder\n.TP\n130\ninterrupted; what was recorded is kept\n";
}

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
