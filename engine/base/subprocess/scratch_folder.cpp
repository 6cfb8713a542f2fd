#include "engine/base/subprocess/scratch_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <regex>

namespace stepwire::subprocess {

namespace {

namespace fs = std::filesystem;

constexpr const char* beginning = "stepwire-work-";
constexpr int attempts = 10;

std::string temporary_folder() {
  const char* given = std::getenv("TMPDIR");
  return given && *given ? given : "/tmp";
}

/// Opens a folder of this user; a closed descriptor if the name is a link or another user's.
io::Descriptor own_folder(const std::string& path) {
  io::Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (folder.open() && (::fstat(folder.number(), &status) != 0 || status.st_uid != ::geteuid()))
    folder.close();
  return folder;
}

bool lock(const io::Descriptor& folder) {
  return ::flock(folder.number(), LOCK_EX | LOCK_NB) == 0;
}

/// True where the folder still has this path: another process may have removed it before it was locked.
bool is_at(const io::Descriptor& folder, const std::string& path) {
  struct stat here {
  }, there{};
  return ::fstat(folder.number(), &here) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         here.st_ino == there.st_ino && here.st_dev == there.st_dev;
}

}  // namespace

ScratchFolder::ScratchFolder() {
  for (int attempt = 0; attempt < attempts && path_.empty(); ++attempt) {
    std::string path = temporary_folder() + "/" + beginning + "XXXXXX";
    if (!::mkdtemp(path.data())) return;
    lock_ = own_folder(path);
    const bool taken = !lock(lock_) && errno == EWOULDBLOCK;  // some file systems do not lock
    if (!taken && is_at(lock_, path)) path_ = path;
  }
  if (!path_.empty()) leftover_.emplace(path_, true);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void remove_abandoned_folders() {
  static const std::regex name(std::string(beginning) + "[A-Za-z0-9]{6}");
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(temporary_folder(), none)) {
    if (!std::regex_match(entry.path().filename().string(), name)) continue;
    const io::Descriptor folder = own_folder(entry.path().string());
    if (folder.open() && lock(folder)) fs::remove_all(entry.path(), none);
  }
}

}  // namespace stepwire::subprocess
