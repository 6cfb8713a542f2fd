#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::cli {

/// The files from which a round was made, so that the next one begins when one of them changes.
class WatchedFiles {
 public:
  void add(const std::string& file) { files_.push_back(file); }
  /// All that a loader has read, also what it could not read.
  void add(const diagram::Loader& loader);
  /// Files of data that the blocks of a diagram read.
  void add(const diagram::Diagram& diagram);
  const std::vector<std::string>& files() const { return files_; }

 private:
  std::vector<std::string> files_;
};

/// Does a round again each time that one of its files has changed, until interrupted. Files are looked at by
/// their path five times a second, so that an editor may write another file and rename it.
ExitCode watch(const std::function<void(WatchedFiles& files)>& round);

/// The time of day, as a line of a round begins: "14:03:59".
std::string time_of_day();

}  // namespace stepwire::cli
