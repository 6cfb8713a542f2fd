#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire {

/// Every block of the library.
const Registry& library();

/// Loads and plans a diagram given as text, which is called test.yaml in messages. The head keys "stepwire",
/// "title", "step" (1 s) and "stop" (3 s) may be left out: they are added behind the text, so that its lines
/// stay what they are.
plan::Plan plan_text(const std::string& yaml, const std::vector<diagram::Setting>& settings = {},
                     const Registry& registry = library());

/// Runs such a text in one go.
run::RunResult result_of(const std::string& yaml, const std::vector<diagram::Setting>& settings = {},
                         const Registry& registry = library());

/// Returns the faults of such a text, one line each; an empty list if there are none.
std::vector<std::string> faults_of(const std::string& yaml,
                                   const std::vector<diagram::Setting>& settings = {},
                                   const Registry& registry = library());

/// A folder of its own for diagrams that use each other, removed at the end.
class DiagramFolder {
 public:
  DiagramFolder();
  ~DiagramFolder();
  DiagramFolder(const DiagramFolder&) = delete;
  DiagramFolder& operator=(const DiagramFolder&) = delete;

  void write(const std::string& name, const std::string& yaml) const;
  /// The plan of a file in it.
  plan::Plan plan(const std::string& name, const std::vector<diagram::Setting>& settings = {}) const;
  table::Table run(const std::string& name, const std::vector<diagram::Setting>& settings = {}) const;
  /// Its faults, with names of files as they are in this folder.
  std::vector<std::string> faults(const std::string& name,
                                  const std::vector<diagram::Setting>& settings = {}) const;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace stepwire
