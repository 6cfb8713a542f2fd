#include "engine/app/cli/blockset_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>

namespace stepwire::cli {

namespace {

void add_option(CLI::App& app, std::vector<std::string>& folders) {
  app.add_option("--blocks", folders, "a folder with further blocks, as C++; may be given several times")
      ->type_name("DIR")
      ->allow_extra_args(false);
}

}  // namespace

void BlocksetOptions::add_to(CLI::App& app) {
  add_option(app, of_program_);
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    add_option(*verb, of_verb_);
}

std::vector<std::string> BlocksetOptions::folders() const {
  std::vector<std::string> result;
  std::set<std::filesystem::path> known;
  for (const auto* folders : {&of_program_, &of_verb_})
    for (const std::string& folder : *folders)
      if (known.insert(std::filesystem::weakly_canonical(folder)).second) result.push_back(folder);
  return result;
}

}  // namespace stepwire::cli
