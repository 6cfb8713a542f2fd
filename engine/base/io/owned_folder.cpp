#include "engine/base/io/owned_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <regex>
#include <sstream>

#include "engine/base/io/file.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".stepwire";
constexpr const char* list_head = "# What runs wrote here; the next one removes it, and nothing else.\n";

/// Folders that runs of this process own.
struct Owned {
  std::mutex mutex;
  std::vector<OwnedFolder*> folders;

  static Owned& of_process() {
    static Owned owned;
    return owned;
  }
};

std::string normal(const std::string& path) {
  std::string result = fs::absolute(path).lexically_normal().string();
  if (result.size() > 1 && result.ends_with('/')) result.pop_back();
  return result;
}

/// True where a listed name leads to a file inside of the folder, after all links are resolved.
bool leads_inside(const fs::path& folder, const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  for (const fs::path& part : name)
    if (part == "..") return false;
  std::error_code error;
  const fs::path parent = fs::weakly_canonical((folder / name).parent_path(), error);
  const fs::path root = fs::weakly_canonical(folder, error);
  return !error && std::mismatch(root.begin(), root.end(), parent.begin(), parent.end()).first == root.end();
}

/// Removes temporary files that an earlier process left unfinished.
void remove_pieces(const fs::path& folder) {
  static const std::regex piece(R"([^]+\.[0-9]+-[0-9]+\.part)");
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    if (std::regex_match(entry.path().filename().string(), piece) && !entry.is_directory(none))
      fs::remove(entry.path(), none);
}

}  // namespace

OwnedFolder::OwnedFolder(const std::string& path, const Spared& spared) : path_(normal(path)), shown_(path) {
  require_folder(path);
  lock();
  try {
    clear(listed(), spared);
  } catch (...) {
    ::close(list_);
    throw;
  }
  Owned& owned = Owned::of_process();
  const std::lock_guard guard(owned.mutex);
  owned.folders.push_back(this);
}

OwnedFolder::~OwnedFolder() {
  Owned& owned = Owned::of_process();
  const std::lock_guard guard(owned.mutex);
  std::erase(owned.folders, this);
  if (names_.empty()) ::unlink((path_ + "/" + list_name).c_str());
  ::close(list_);
}

void OwnedFolder::reserve(const std::vector<std::string>& names) {
  for (const std::string& name : names) refuse_foreign(name, shown_ + "/" + name);
  for (const std::string& name : names) note(name);
}

void OwnedFolder::lock() {
  const std::string file = path_ + "/" + list_name;
  struct stat status {};
  do {  // retried where another run has just removed the list
    if (list_ >= 0) ::close(list_);
    list_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (list_ < 0) refuse_file(shown_ + "/" + list_name, errno);
    if (::flock(list_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {  // some file systems do not lock
      ::close(list_);
      throw EnvironmentError(fmt::format(
          "{}: another run is writing into this folder; give --out another one, or wait", shown_));
    }
  } while (::fstat(list_, &status) == 0 && status.st_nlink == 0);
}

OwnedFolder::Files OwnedFolder::listed() const {
  std::istringstream lines(read_file(path_ + "/" + list_name));
  Files names;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('#') && leads_inside(path_, line)) names.insert(line);
  return names;
}

void OwnedFolder::clear(const Files& listed, const Spared& spared) {
  Files stays;
  if (!listed.empty() && spared)
    for (const std::string& path : spared()) stays.insert(normal(path));
  if (::ftruncate(list_, 0) != 0) refuse_file(path_ + "/" + list_name, errno);
  std::set<fs::path> folders{path_};
  std::error_code none;
  for (const std::string& name : listed) {
    const fs::path file = fs::path(path_) / name;
    folders.insert(file.parent_path());
    if (stays.contains(file.string())) {
      note(name);
    } else if (!fs::is_directory(fs::symlink_status(file, none))) {
      fs::remove(file, none);
    }
  }
  for (const fs::path& folder : folders) remove_pieces(folder);
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    if (*folder != path_) fs::remove(*folder, none);  // only removes an empty folder
}

/// Throws EnvironmentError for a file that no run wrote. Leftovers of the previous run are already removed;
/// any other file is foreign.
void OwnedFolder::refuse_foreign(const std::string& name, const std::string& shown) const {
  if (!leads_inside(path_, name))
    throw EnvironmentError(fmt::format("{}: a link leads out of the folder of the results", shown));
  std::error_code none;
  if (names_.contains(name) || !fs::exists(fs::symlink_status(fs::path(path_) / name, none))) return;
  throw EnvironmentError(fmt::format(
      "{}: there is one already that no run wrote; give --out another folder, or move it away", shown));
}

/// Adds a name to the list. A name with a line break is left out, since it would be two lines of the list.
void OwnedFolder::note(const std::string& name) {
  if (!names_.insert(name).second || text::visible(name) != name || name.starts_with('#')) return;
  const std::string text = (names_.size() == 1 ? list_head : "") + name + "\n";
  const ssize_t written = ::write(list_, text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size()))
    refuse_file(shown_ + "/" + list_name, written < 0 ? errno : ENOSPC);
}

void note_written(const std::string& path) {
  Owned& owned = Owned::of_process();
  const std::lock_guard guard(owned.mutex);
  if (owned.folders.empty()) return;
  const std::string file = normal(path);
  for (OwnedFolder* folder : owned.folders)
    if (file.starts_with(folder->path_ + "/")) {
      const std::string name = file.substr(folder->path_.size() + 1);
      folder->refuse_foreign(name, path);
      folder->note(name);
    }
}

}  // namespace stepwire::io
