#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stepwire::cli {

/// The folders with blocks from outside that a call names. Code is only ever what the call or its environment
/// names, never what a diagram file does.
class BlocksetOptions {
 public:
  /// Adds `--blocks` to a program and to all verbs that it has.
  void add_to(CLI::App& app);
  /// As they are named, each once.
  std::vector<std::string> folders() const;

 private:
  std::vector<std::string> of_program_, of_verb_;  ///< before and behind the verb
};

}  // namespace stepwire::cli
