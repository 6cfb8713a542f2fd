#include "engine/base/subprocess/scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>

namespace stepwire::subprocess {

ScratchFolder::ScratchFolder() {
  const char* given = std::getenv("TMPDIR");
  std::string path = (given && *given ? given : "/tmp") + std::string("/stepwire-XXXXXX");
  if (!::mkdtemp(path.data())) return;
  path_ = path;
  leftover_.emplace(path_, true);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace stepwire::subprocess
