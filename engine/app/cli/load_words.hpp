#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Options for reading diagram files: --set, --set-from, --parts, --large, and --stop of some verbs.
struct LoadWords {
  std::vector<std::string> set;
  std::vector<std::string> set_from;
  std::vector<std::string> parts;  ///< folders
  std::string stop;
  bool large = false;
};

/// Declares all of them but --stop.
void add_load_options(CLI::App& verb, LoadWords& words);

/// Folders of parts come before those of $STEPWIRE_PARTS. Settings of files come first, so that the call's
/// own win. Throws Error for what is not "name=value" and for a file that is no flat list of values,
/// EnvironmentError for one that cannot be read.
session::LoadOptions load_options(const LoadWords& words);

}  // namespace stepwire::cli
