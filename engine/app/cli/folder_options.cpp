#include "engine/app/cli/folder_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

void add_option(CLI::App& app, const std::string& name, const std::string& about,
                std::vector<std::string>& folders) {
  app.add_option(name, folders, about)->type_name("DIR")->allow_extra_args(false);
}

/// Throws Error for a path in which no parts can be looked for.
void require_part_folder(const std::string& folder) {
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{"--parts " + folder, {}}, "", message, {}});
  };
  std::error_code none;
  if (!std::filesystem::is_directory(folder, none)) refuse("no such folder");
  if (folder.find(':') != std::string::npos)
    refuse("a folder of parts has no ':' in its path, which separates those of STEPWIRE_PARTS; rename it");
}

}  // namespace

void FolderOption::add_to(CLI::App& app, const std::string& name, const std::string& about) {
  add_option(app, name, about, of_program_);
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    add_option(*verb, name, about, of_verb_);
}

std::vector<std::string> FolderOption::folders() const {
  std::vector<std::string> result;
  std::set<std::filesystem::path> known;
  for (const auto* folders : {&of_program_, &of_verb_})
    for (const std::string& folder : *folders)
      if (known.insert(std::filesystem::weakly_canonical(folder)).second) result.push_back(folder);
  return result;
}

void look_for_parts(const std::vector<std::string>& folders) {
  if (folders.empty()) return;
  for (const std::string& folder : folders) require_part_folder(folder);
  const char* known = std::getenv("STEPWIRE_PARTS");
  std::string all = fmt::format("{}", fmt::join(folders, ":"));
  if (known && *known) all += std::string(":") + known;
  ::setenv("STEPWIRE_PARTS", all.c_str(), 1);
}

}  // namespace stepwire::cli
