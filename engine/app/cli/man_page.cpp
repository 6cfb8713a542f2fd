#include "engine/app/cli/man_page.hpp"

#include <fmt/format.h>

#include "engine/app/session/version.hpp"

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

}  // namespace

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
         ".SH EXIT STATUS\n.TP\n0\ndone, all claims hold\n.TP\n1\na claim fails, or what is verified "
         "differs\n"
         ".TP\n2\nthe diagram or the call is wrong\n.TP\n3\nthe surroundings are: a full disk, a missing "
         "program "
         "or folder\n.TP\n130\ninterrupted; what was recorded is kept\n";
}

}  // namespace stepwire::cli
