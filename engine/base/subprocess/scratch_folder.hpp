#pragma once

#include <optional>
#include <string>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/leftovers.hpp"

namespace stepwire::subprocess {

/// Folder for temporary files, removed with all its content. Its path is empty if none could be created. It
/// is locked during its lifetime, so that other processes can detect whether its owner still lives.
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

/// Removes the scratch folders of this user that killed processes left.
void remove_abandoned_folders();

}  // namespace stepwire::subprocess
