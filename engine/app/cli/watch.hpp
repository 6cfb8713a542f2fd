#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::cli {

/// Input files of a round, whose changes start the next one.
class WatchedFiles {
 public:
  void add(const std::string& file) { files_.push_back(file); }
  /// Adds all files that the loader has read or tried to read.
  void add(const diagram::Loader& loader);
  /// Adds the data files that blocks of the diagram read.
  void add(const diagram::Diagram& diagram);
  const std::vector<std::string>& files() const { return files_; }

 private:
  std::vector<std::string> files_;
};

/// Repeats a round after each change of its files, until interrupted. Files are polled by path five times a
/// second, so an editor may replace a file by renaming.
ExitCode watch(const std::function<void(WatchedFiles& files)>& round);

/// Returns the time of day for the first line of a round: "14:03:59".
std::string time_of_day();

}  // namespace stepwire::cli
