#include "engine/base/io/cache.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <regex>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::io {

namespace {

namespace fs = std::filesystem;

/// Seal at the end of an entry: a word, and the hash of name and content.
constexpr std::string_view seal_word = "\nstepwire ";
constexpr std::size_t seal_size = seal_word.size() + 33;

std::string seal_of(const std::string& name, std::string_view content) {
  return fmt::format("{}{}\n", seal_word, hash::Hash().add(name).add(content).text());
}

/// First problem of the process, for take_cache_problem().
class Problem {
 public:
  static Problem& of_process() {
    static Problem problem;
    return problem;
  }
  void note(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(noted_, true)) text_ = text;
  }
  std::string take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(text_, "");
  }

 private:
  std::mutex mutex_;
  std::string text_;
  bool noted_ = false;
};

void note_problem(const std::string& path, const std::string& what) {
  Problem::of_process().note(path + ": " + what);
}

void note_errno(const std::string& path) {
  note_problem(path, std::generic_category().message(errno));
}

/// True where an open file or folder is accessible to the caller alone; otherwise records the reason.
bool is_own(int descriptor, const std::string& path, bool folder) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return false;
  if (folder ? !S_ISDIR(status.st_mode) : !S_ISREG(status.st_mode)) {
    note_problem(path, folder ? "is no folder" : "is no file");
  } else if (status.st_uid != ::geteuid()) {
    note_problem(path, "belongs to another user");
  } else if ((status.st_mode & 077u) != 0) {
    note_problem(path, fmt::format("is open to other users (mode {:04o}); chmod {} closes it",
                                   status.st_mode & 07777u, folder ? "700" : "600"));
  } else {
    return true;
  }
  return false;
}

/// Opens the folder; a closed descriptor if it is missing or accessible to others.
Descriptor open_folder(const std::string& path) {
  if (path.empty()) note_problem("the cache", "has no place; HOME or STEPWIRE_CACHE name one");
  Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.open() && errno != ENOENT) note_errno(path);
  return folder.open() && is_own(folder.number(), path, true) ? std::move(folder) : Descriptor();
}

void make_folder(const fs::path& path) {
  std::error_code ignored;  // an error here appears again on opening
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), ignored);
  ::mkdir(path.c_str(), 0700);
}

std::string read_all(int file) {
  std::string content, piece(1 << 16, '\0');
  for (ssize_t got = 1; got != 0;) {
    got = ::read(file, piece.data(), piece.size());
    if (got < 0 && errno != EINTR) return {};
    if (got > 0) content.append(piece, 0, static_cast<std::size_t>(got));
  }
  return content;
}

bool write_whole(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0;
}

/// True for a name that any version of this program gives to its entries.
bool is_entry(const std::string& name) {
  static const std::regex entry(R"([0-9a-f]{16,32}\.(so|svg|pdf)(\.[0-9]+-[0-9]+\.part)?)");
  return std::regex_match(name, entry);
}

}  // namespace

std::string cache_folder() {
  const auto variable = [](const char* name) -> std::string {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (!variable("STEPWIRE_CACHE").empty()) return variable("STEPWIRE_CACHE");
  // The XDG Base Directory Specification requires relative paths to be ignored.
  if (variable("XDG_CACHE_HOME").starts_with('/')) return variable("XDG_CACHE_HOME") + "/stepwire";
  if (variable("HOME").starts_with('/')) return variable("HOME") + "/.cache/stepwire";
  return "";
}

std::string take_cache_problem() {
  return Problem::of_process().take();
}

std::optional<std::string> Cache::find(const std::string& name) const {
  const Descriptor folder = open_folder(folder_);
  if (!folder.open()) return std::nullopt;
  const std::string path = folder_ + "/" + name;
  // O_NONBLOCK: opening a pipe of this name would block.
  const Descriptor file(
      ::openat(folder.number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.open() && errno != ENOENT) note_errno(path);
  if (!file.open() || !is_own(file.number(), path, false)) return std::nullopt;
  std::string content = read_all(file.number());
  const std::size_t size = content.size() - std::min(content.size(), seal_size);
  if (content.substr(size) != seal_of(name, std::string_view(content).substr(0, size))) return std::nullopt;
  ::futimens(file.number(), nullptr);  // marks it as recently used
  content.resize(size);
  return content;
}

void Cache::keep(const std::string& name, const std::string& content) const {
  make_folder(folder_);
  const Descriptor folder = open_folder(folder_);
  if (!folder.open()) return note_problem(folder_, "cannot be used");  // unless an earlier reason is recorded
  drop_old();
  write(folder.number(), name, content + seal_of(name, content));
}

void Cache::drop(const std::string& name) const {
  const Descriptor folder = open_folder(folder_);
  if (folder.open()) ::unlinkat(folder.number(), name.c_str(), 0);
}

void Cache::write(int folder, const std::string& name, const std::string& content) const {
  const std::string temporary = temporary_beside(name);
  const Leftover leftover(fs::absolute(folder_ + "/" + temporary).string());
  Descriptor file(
      ::openat(folder, temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  const bool kept = file.open() && write_whole(file.number(), content) &&
                    ::renameat(folder, temporary.c_str(), folder, name.c_str()) == 0;
  if (!kept) {
    note_errno(folder_);
    ::unlinkat(folder, temporary.c_str(), 0);
  }
  ::fsync(folder);
}

void Cache::drop_old() const {
  constexpr std::chrono::hours forgotten{1};  // age of a temporary file that no process writes any more
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
    if (!is_entry(entry.path().filename().string())) continue;
    const fs::file_time_type time = entry.last_write_time(none);
    const bool stale =
        entry.path().extension() == ".part" && time + forgotten < fs::file_time_type::clock::now();
    if (stale) fs::remove(entry.path(), none);
    if (stale) continue;
    bytes += entry.file_size(none);
    files.emplace_back(time, entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& [time, path] : files) {
    if (bytes <= max_bytes_) return;
    bytes -= std::min(bytes, fs::file_size(path, none));
    fs::remove(path, none);
  }
}

}  // namespace stepwire::io
