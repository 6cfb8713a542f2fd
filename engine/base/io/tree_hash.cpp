#include "engine/base/io/tree_hash.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <mutex>

#include "engine/base/hash/sha256.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::io {

namespace fs = std::filesystem;

static std::string content_of(const fs::directory_entry& entry) {
  if (entry.is_symlink()) return "link:" + fs::read_symlink(entry.path()).string();
  if (!entry.is_regular_file()) throw EnvironmentError(entry.path().string() + ": is no file");
  return read_file(entry.path().string());
}

TreeHash tree_hash(const std::string& folder) try {
  std::map<std::string, std::string> hashes;  // std::string orders by bytes
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_symlink() || !entry.is_directory())
      hashes[entry.path().lexically_relative(folder).generic_string()] = hash::sha256_of(content_of(entry));
  std::string list;
  for (const auto& [path, hash] : hashes) (list += path).append(1, '\0').append(hash) += '\n';
  return {hash::sha256_of(list), hashes.size()};
} catch (const fs::filesystem_error& error) {
  throw EnvironmentError(folder + ": " + error.code().message());
}

namespace {

constexpr std::int64_t second = 1'000'000'000;

std::int64_t nanoseconds(const timespec& time) {
  return time.tv_sec * second + time.tv_nsec;
}

/// State of a folder, by which a change is found without its content.
struct TreeState {
  std::string files;         ///< path, number, size and times of each
  std::int64_t changed = 0;  ///< latest time of a change [ns]
};

TreeState state_of(const std::string& folder) try {
  TreeState state;
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    struct stat found {};
    const std::string path = entry.path().string();
    if (::lstat(path.c_str(), &found) != 0) throw EnvironmentError(path + ": " + std::strerror(errno));
    state.changed = std::max(state.changed, nanoseconds(found.st_ctim));
    files[path] = fmt::format("{} {} {} {} {}", found.st_dev, found.st_ino, found.st_size,
                              nanoseconds(found.st_mtim), nanoseconds(found.st_ctim));
  }
  for (const auto& [path, numbers] : files) (state.files += path).append(1, '\0').append(numbers) += '\n';
  return state;
} catch (const fs::filesystem_error& error) {
  throw EnvironmentError(folder + ": " + error.code().message());
}

/// Hashes of this process, by folder.
struct KnownHashes {
  struct Known {
    std::string files, sha256;
  };
  std::mutex mutex;
  std::map<std::string, Known> known;
};

}  // namespace

std::string known_tree_hash(const std::string& folder) {
  static KnownHashes hashes;
  const TreeState state = state_of(folder);
  {
    const std::lock_guard lock(hashes.mutex);
    const auto found = hashes.known.find(folder);
    if (found != hashes.known.end() && found->second.files == state.files) return found->second.sha256;
  }
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const std::string sha256 = tree_hash(folder).sha256;
  const std::lock_guard lock(hashes.mutex);
  if (state.changed + 2 * second < nanoseconds(now) && state_of(folder).files == state.files)
    hashes.known[folder] = {state.files, sha256};
  else
    hashes.known.erase(folder);
  return sha256;
}

}  // namespace stepwire::io
