#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Options for loading diagram files: --set, --set-from, --large, and --stop of some verbs.
struct LoadWords {
  std::vector<std::string> set;
  std::vector<std::string> set_from;
  std::string stop;
  bool large = false;
};

/// Declares all options but --stop.
void add_load_options(CLI::App& verb, LoadWords& words);

/// Converts the words to load options. Settings of files precede those of the call, which therefore win.
/// Throws Error for a setting that is not "name=value" and for a file that is no flat map of values;
/// EnvironmentError for an unreadable file.
session::LoadOptions load_options(const LoadWords& words);

}  // namespace stepwire::cli
