#pragma once

#include <optional>
#include <string>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/leftovers.hpp"

namespace stepwire::subprocess {

/// A folder for temporary files; it goes with all that is in it. Its path is empty where none could be made.
/// It is locked while it is in use, so that another process sees whether its owner still lives.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  io::Descriptor lock_;
  std::optional<io::Leftover> leftover_;
};

/// Removes the scratch folders of this user whose processes were killed.
void remove_abandoned_folders();

}  // namespace stepwire::subprocess
