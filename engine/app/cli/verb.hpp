#pragma once

#include <functional>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/model/block/registry.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

/// What a call of a verb does, once its words are read.
using Action = std::function<ExitCode(const Registry&)>;

/// A verb of the command line. Its file declares its options, and what it does with them.
struct Verb {
  const char* name;
  const char* about;   ///< its line of `stepwire --help`
  const char* footer;  ///< the end of its own help: an example
  Action (*declare)(CLI::App&);
};

/// All verbs, in the order of `stepwire --help`.
const std::vector<Verb>& verbs();

}  // namespace stepwire::cli
