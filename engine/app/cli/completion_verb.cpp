#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/call_words.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

using text::shell_word;

std::string all_names(const VerbWords& verb) {
  std::string names;
  for (const OptionWords& option : verb.options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

std::string verb_names(const std::vector<VerbWords>& verbs) {
  std::string names;
  for (const VerbWords& verb : verbs) names += (names.empty() ? "" : " ") + verb.name;
  return names;
}

// bash

/// Returns a case that completes the choices of an option or a positional argument.
std::string choices_case(const std::string& pattern, const std::vector<std::string>& choices) {
  return fmt::format("    {}) COMPREPLY=($(compgen -W {} -- \"$word\")); return ;;\n", pattern,
                     shell_word(fmt::format("{}", fmt::join(choices, " "))));
}

std::string bash_verb(const VerbWords& verb) {
  std::string values, words;
  for (const OptionWords& option : verb.options)
    if (!option.choices.empty())
      values += choices_case(fmt::format("{}", fmt::join(option.names, "|")), option.choices);
  for (const OptionWords& word : verb.positionals)
    for (const std::string& choice : word.choices) words += " " + choice;
  std::string text = fmt::format("  {})\n", verb.name);
  if (!values.empty()) text += fmt::format("    case $before in\n{}    esac\n", values);
  return text + fmt::format("    options={} choices={} ;;\n", shell_word(all_names(verb)), shell_word(words));
}

// zsh

/// Escapes a text for a specification of _arguments, in which brackets and colons have a meaning. The result
/// is used in single quotes.
std::string zsh_text(std::string_view plain) {
  std::string text;
  for (const char c : plain) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

std::string zsh_values(const OptionWords& option) {
  if (option.value.empty()) return "";
  return option.choices.empty()
             ? fmt::format(":{}:_files", zsh_text(option.value))
             : fmt::format(":{}:({})", zsh_text(option.value), fmt::join(option.choices, " "));
}

std::string zsh_option(const OptionWords& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += " \\\n        " + shell_word(fmt::format("{}{}[{}]{}", option.repeated ? "*" : "", name,
                                                     zsh_text(option.about), zsh_values(option)));
  return text;
}

std::string zsh_verb(const VerbWords& verb) {
  std::string text = fmt::format("    {})\n      _arguments", verb.name);
  for (const OptionWords& option : verb.options) text += zsh_option(option);
  for (const OptionWords& word : verb.positionals)
    text += " \\\n        " + shell_word(fmt::format("{}{}", word.repeated ? "*" : "", zsh_values(word)));
  return text + " ;;\n";
}

// fish

std::string fish_option(const std::string& condition, const OptionWords& option) {
  std::string text = "complete -c stepwire -n " + shell_word(condition);
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += " -r";
  if (!option.choices.empty())
    text += " -f -a " + shell_word(fmt::format("{}", fmt::join(option.choices, " ")));
  return text + " -d " + shell_word(option.about) + "\n";
}

std::string fish_verb(const VerbWords& verb) {
  std::string text = fmt::format("complete -c stepwire -n __fish_use_subcommand -f -a {} -d {}\n", verb.name,
                                 shell_word(verb.about));
  const std::string condition = "__fish_seen_subcommand_from " + verb.name;
  for (const OptionWords& option : verb.options) text += fish_option(condition, option);
  for (const OptionWords& word : verb.positionals)
    if (!word.choices.empty())
      text += fmt::format("complete -c stepwire -n {} -f -a {}\n", shell_word(condition),
                          shell_word(fmt::format("{}", fmt::join(word.choices, " "))));
  return text;
}

/// Return shell scripts that complete verbs, options, their choices, and files. The scripts are generated
/// from the declarations of the verbs and run no other program.
std::string bash_completion(const VerbWords& program, const std::vector<VerbWords>& verbs) {
  std::string cases;
  for (const VerbWords& verb : verbs) cases += bash_verb(verb);
  return fmt::format(
      "# Completion of stepwire for bash.\n"
      "_stepwire() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} verb= options= choices= "
      "i\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    if [[ \" {0} \" == *\" ${{COMP_WORDS[i]}} \"* ]]; then verb=${{COMP_WORDS[i]}}; break; fi\n"
      "  done\n"
      "  case $verb in\n"
      "  '') options={1} choices={2} ;;\n"
      "{3}"
      "  esac\n"
      "  if [[ $word == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$word\"));\n"
      "  elif [[ -n $choices ]]; then COMPREPLY=($(compgen -W \"$choices\" -- \"$word\"));\n"
      "  else compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); fi\n"
      "}}\n"
      "complete -F _stepwire stepwire\n",
      verb_names(verbs), shell_word(all_names(program)), shell_word(verb_names(verbs)), cases);
}

std::string zsh_completion(const VerbWords& program, const std::vector<VerbWords>& verbs) {
  std::string options, lines, cases;
  for (const OptionWords& option : program.options) options += zsh_option(option);
  for (const VerbWords& verb : verbs) {
    lines += "    " + shell_word(fmt::format("{}:{}", verb.name, zsh_text(verb.about))) + "\n";
    cases += zsh_verb(verb);
  }
  return fmt::format(
      "#compdef stepwire\n"
      "_stepwire() {{\n"
      "  local state line\n"
      "  local -a verbs\n"
      "  verbs=(\n{}  )\n"
      "  _arguments -C{} \\\n        '1: :->verb' '*:: :->words'\n"
      "  case $state in\n"
      "  verb) _describe verb verbs ;;\n"
      "  words)\n"
      "    case $line[1] in\n{}    esac ;;\n"
      "  esac\n"
      "}}\n"
      "_stepwire \"$@\"\n",
      lines, options, cases);
}

std::string fish_completion(const VerbWords& program, const std::vector<VerbWords>& verbs) {
  std::string text = "# Completion of stepwire for fish.\n";
  for (const OptionWords& option : program.options) text += fish_option("__fish_use_subcommand", option);
  for (const VerbWords& verb : verbs) text += fish_verb(verb);
  return text;
}

using Script = std::string (*)(const VerbWords& program, const std::vector<VerbWords>& verbs);

Script script_for(const std::string& shell) {
  if (shell == "bash") return bash_completion;
  return shell == "zsh" ? zsh_completion : fish_completion;
}

Action declare_completion(CLI::App& verb) {
  const auto shell = std::make_shared<std::string>();
  verb.add_option("SHELL", *shell, "the shell")->required()->check(choice({"bash", "zsh", "fish"}));
  return [shell, program = verb.get_parent()](const Registry&) {
    put_data(script_for(*shell)(program_words(*program), verb_words(*program)));
    return ExitCode::done;
  };
}

}  // namespace

Verb completion_verb() {
  return {"completion", "print the script by which a shell completes calls of stepwire",
          "Example:\n  source <(stepwire completion bash)", declare_completion};
}

}  // namespace stepwire::cli
