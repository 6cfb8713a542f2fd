#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Options that name folders with external blocks. Code is loaded only from folders that the call or its
/// environment names, never from those of a diagram file.
class BlocksetOptions {
 public:
  /// Adds `--blocks` to a program and to all its verbs.
  void add_to(CLI::App& app);
  /// Returns the named folders in order, without duplicates.
  std::vector<std::string> folders() const;

 private:
  std::vector<std::string> of_program_, of_verb_;  ///< before and after the verb
};

}  // namespace stepwire::cli
