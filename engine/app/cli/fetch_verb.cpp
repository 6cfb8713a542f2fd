#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/fetch/fetch.hpp"

namespace stepwire::cli {
namespace {

namespace fs = std::filesystem;

/// Returns the diagram files of the present folder.
std::vector<std::string> diagrams_here() {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(".")) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || (path.extension() != ".yaml" && path.extension() != ".yml")) continue;
    const std::string name = path.filename().string();
    if (!diagram::uses_of(yaml::read_document(name).root).empty()) files.push_back(name);
  }
  std::ranges::sort(files);
  return files;
}

ExitCode fetch(std::vector<std::string> files) {
  if (files.empty()) files = diagrams_here();
  const fetch::Fetched fetched = fetch::fetch_parts(files);
  for (const fetch::FetchedUse& one : fetched.uses) {
    put_data(fmt::format("{}: {} {} of {} from {}{}\n", one.use.name, one.files,
                         one.files == 1 ? "file" : "files", one.use.rev, one.use.git,
                         one.was_there ? ", there already" : ""));
    for (const std::string& left_out : one.left_out) complain("{}: {}\n", one.use.name, left_out);
  }
  if (!fetched.faults.empty()) throw yaml::Error(fetched.faults);
  if (fetched.uses.empty()) say("nothing is used from other repositories\n");
  return ExitCode::done;
}

Action declare_fetch(CLI::App& verb) {
  const auto files = std::make_shared<std::vector<std::string>>();
  verb.add_option("FILES", *files, "diagram files; without them those of the present folder");
  return [files](const Registry&) { return guarded([&] { return fetch(*files); }); };
}

}  // namespace

Verb fetch_verb() {
  return {"fetch", "fetch the repositories whose files are parts, as the section `uses` names them",
          "Example:\n  stepwire fetch rig.yaml\n"
          "A missing or wrong sha256 is printed with the right one. No other verb connects to a repository.",
          declare_fetch};
}

}  // namespace stepwire::cli
