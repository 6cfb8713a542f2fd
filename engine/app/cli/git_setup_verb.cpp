#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/difference/revision.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

namespace fs = std::filesystem;

const std::string attributes = "*.yaml diff=stepwire merge=stepwire";

/// A setting of git.
struct GitSetting {
  std::string name, value;
};

/// Returns the program as git calls it: by its name where that is on the PATH.
std::string program() {
  if (!subprocess::find_program("stepwire").empty()) return "stepwire";
  std::error_code none;
  const std::string self = fs::read_symlink("/proc/self/exe", none).string();
  return self.empty() ? "stepwire" : text::shell_word(self);
}

std::vector<GitSetting> settings() {
  const std::string call = program();
  return {{"diff.stepwire.command", call + " diff"},
          {"diff.stepwire.textconv", call + " diff --text"},
          {"merge.stepwire.name", "diagrams of Stepwire by meaning"},
          {"merge.stepwire.driver", call + " merge %O %A %B %P"}};
}

void print() {
  for (const auto& [name, value] : settings())
    put_data(fmt::format("git config {} {}\n", name, text::shell_word(value)));
  put_data(fmt::format("echo {} >> .gitattributes\n", text::shell_word(attributes)));
}

/// Adds the line to the file of attributes, unless it has it.
void add_attributes(const std::string& top) {
  const std::string path = top + "/.gitattributes";
  std::string text = fs::exists(path) ? io::read_file(path) : "";
  if (("\n" + text).find("\n" + attributes + "\n") != std::string::npos) return;
  if (!text.empty() && text.back() != '\n') text += '\n';
  io::write_file(path, text + attributes + "\n");
}

void apply() {
  const std::string top = difference::git_output(".", {"rev-parse", "--show-toplevel"});
  for (const auto& [name, value] : settings()) difference::git_output(top, {"config", name, value});
  add_attributes(top);
  say("git compares and merges diagrams by meaning in {}\n", top);
}

Action declare_git_setup(CLI::App& verb) {
  const auto is_applied = std::make_shared<bool>(false);
  verb.add_flag("--apply", *is_applied, "run the commands in the repository of the present folder");
  return [is_applied](const Registry&) {
    *is_applied ? apply() : print();
    return ExitCode::done;
  };
}

}  // namespace

Verb git_setup_verb() {
  return {"git-setup", "print the commands by which git compares and merges diagrams by meaning",
          "Example:\n  stepwire git-setup --apply\n  git diff HEAD~1 rig.yaml", declare_git_setup};
}

}  // namespace stepwire::cli
