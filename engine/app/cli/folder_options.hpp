#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Option that names folders, for a program and all its verbs. Every verb that opens a diagram needs the
/// folders of blocks and of parts, so they are declared in one place.
class FolderOption {
 public:
  /// Adds the option to a program and to all its verbs.
  void add_to(CLI::App& app, const std::string& name, const std::string& about);
  /// Returns the named folders in order, without duplicates.
  std::vector<std::string> folders() const;

 private:
  std::vector<std::string> of_program_, of_verb_;  ///< before and after the verb
};

/// Puts folders in front of those of STEPWIRE_PARTS, which child processes inherit. Throws Error for a
/// path that is no folder or contains ':'.
void look_for_parts(const std::vector<std::string>& folders);

}  // namespace stepwire::cli
