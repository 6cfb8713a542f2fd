#pragma once

#include <functional>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/model/block/registry.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Action of a verb, after its arguments are parsed.
using Action = std::function<ExitCode(const Registry&)>;

/// Verb of the command line. Its source file declares its options and its action.
struct Verb {
  const char* name;
  const char* about;   ///< line in `stepwire --help`
  const char* footer;  ///< end of its own help: an example
  Action (*declare)(CLI::App&);
};

/// Returns all verbs in the order of `stepwire --help`.
const std::vector<Verb>& verbs();

}  // namespace stepwire::cli
