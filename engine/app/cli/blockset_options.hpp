#pragma once

#include <string>
#include <vector>

#include "engine/model/block/registry.hpp"

namespace CLI {
class App;
}

namespace stepwire {

/// The folders with blocks from outside that a call names. Code is only ever what the call or its environment
/// names, never what a diagram file does.
class BlocksetOptions {
 public:
  /// Adds `--blocks` to a program and to all verbs that it has.
  void add_to(CLI::App& app);
  /// Compiles and loads them, those of the environment first. Throws as load_blockset().
  void load(Registry& registry) const;

 private:
  std::vector<std::string> of_program_, of_verb_;  ///< before and behind the verb
};

}  // namespace stepwire
