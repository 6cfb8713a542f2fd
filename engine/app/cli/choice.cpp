#include "engine/app/cli/choice.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

CLI::Validator choice(const std::vector<std::string>& words) {
  const auto problem = [words](std::string& word) -> std::string {
    if (std::ranges::find(words, word) != words.end()) return "";
    const std::string all = fmt::format("It takes: {}", fmt::join(words, ", "));
    return (fmt::format("does not take '{}'", word) + yaml::did_you_mean(word, words, all)).text();
  };
  return CLI::Validator(problem, CLI::IsMember(words).get_description());
}

std::vector<std::string> long_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string fault_of_call(const CLI::App& program, const CLI::Error& error) {
  const auto verbs = program.get_subcommands();
  const CLI::App& called = verbs.empty() ? program : *verbs.front();
  const bool has_extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  for (const std::string& word : has_extras ? program.remaining(true) : std::vector<std::string>{}) {
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string form = verbs.empty() ? "stepwire" : "stepwire " + called.get_name();
    return text::visible((fmt::format("there is no option '{}'", name) +
                          yaml::did_you_mean(name, long_options(called), form + " --help lists them"))
                             .text());
  }
  return text::visible(error.what()) + "; stepwire --help and stepwire VERB --help tell more";
}

}  // namespace stepwire::cli
