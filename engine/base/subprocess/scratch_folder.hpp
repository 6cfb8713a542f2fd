#pragma once

#include <optional>
#include <string>

#include "engine/base/io/leftovers.hpp"

namespace stepwire::subprocess {

/// A folder for temporary files; it goes with all that is in it. Its path is empty where none could be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::optional<io::Leftover> leftover_;
};

}  // namespace stepwire::subprocess
