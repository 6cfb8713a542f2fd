#include "engine/app/cli/call_words.hpp"

#include <CLI/CLI.hpp>
#include <string_view>

namespace stepwire::cli {

namespace {

/// Returns the choices in a type such as "TEXT:{bash,fish,zsh}", which is CLI11's notation of a closed list.
std::vector<std::string> choices_of(std::string_view type) {
  std::vector<std::string> result;
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string_view::npos || close == std::string_view::npos) return result;
  for (std::size_t at = open + 1; at <= close;) {
    const std::size_t end = std::min(type.find(',', at), close);
    result.emplace_back(type.substr(at, end - at));
    at = end + 1;
  }
  return result;
}

/// Returns the placeholder of a value: the option text, or CLI11's name of the type.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type =
      option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
  return type.substr(0, type.find_first_of(": "));
}

OptionWords words_of(const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_positional()) words.names = {option.get_name(true)};
  words.value = value_of(option);
  words.choices = choices_of(option.get_type_name());
  words.about = option.get_description();
  words.required = option.get_required();
  words.repeated = option.get_items_expected_max() > 1;
  return words;
}

VerbWords words_of(const CLI::App& app) {
  VerbWords words{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    (option->get_positional() ? words.positionals : words.options).push_back(words_of(*option));
  return words;
}

}  // namespace

VerbWords program_words(const CLI::App& program) {
  VerbWords words = words_of(program);
  words.name.clear();
  return words;
}

std::vector<VerbWords> verb_words(const CLI::App& program) {
  std::vector<VerbWords> result;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
    result.push_back(words_of(*verb));
  return result;
}

}  // namespace stepwire::cli
