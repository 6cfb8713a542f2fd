#include "engine/app/studio/beneath.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "engine/app/studio/fault.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Fault(fmt::format("{}: {}", text::visible(path), why));
}

[[noreturn]] void refuse(const std::string& path, int reason) {
  refuse(path, std::generic_category().message(reason));
}

/// Opens a path part by part, for systems without openat2(). It follows no symbolic link at all.
io::Descriptor walk_beneath(int folder, const fs::path& path, int flags) {
  io::Descriptor above(::dup(folder));
  for (auto part = path.begin(); part != path.end() && above.open(); ++part) {
    const bool is_last = std::next(part) == path.end();
    if (*part == "..") errno = EXDEV;
    if (*part == "..") return io::Descriptor();
    const int how = is_last ? flags : O_PATH | O_DIRECTORY;
    above = io::Descriptor(::openat(above.number(), part->c_str(), how | O_NOFOLLOW | O_CLOEXEC));
  }
  return above;
}

io::Descriptor open_beneath(int folder, const std::string& path, int flags) {
  open_how how{};
  how.flags = static_cast<unsigned>(flags | O_CLOEXEC);
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  const auto opened = ::syscall(SYS_openat2, folder, path.c_str(), &how, sizeof how);
  if (opened >= 0) return io::Descriptor(static_cast<int>(opened));
  return errno == ENOSYS || errno == EPERM ? walk_beneath(folder, path, flags) : io::Descriptor();
}

std::string read_all(int file, const std::string& path) {
  constexpr std::size_t most = 8u << 20u;  // the limit for diagrams, too
  std::string content, piece(1 << 16, '\0');
  for (ssize_t got = 1; got != 0;) {
    got = ::read(file, piece.data(), piece.size());
    if (got < 0 && errno != EINTR) refuse(path, errno);
    if (got > 0) content.append(piece, 0, static_cast<std::size_t>(got));
    if (content.size() > most) refuse(path, "is larger than 8 MB");
  }
  return content;
}

void write_all(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file) != 0) refuse(path, errno);
}

/// Temporary sibling of a file; the destructor removes it unless it was renamed.
class FileBeside {
 public:
  FileBeside(int folder, std::string name) : folder_(folder), name_(std::move(name)) {}
  ~FileBeside() { ::unlinkat(folder_, name_.c_str(), 0); }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  void write(std::string_view text, mode_t mode, const std::string& path) const {
    const io::Descriptor file(
        ::openat(folder_, name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!file.open()) refuse(path, errno);
    write_all(file.number(), text, path);
    if (::fchmod(file.number(), mode & 07777u) != 0) refuse(path, errno);
  }
  void rename_to(const std::string& name, const std::string& path) const {
    if (::renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) refuse(path, errno);
    ::fsync(folder_);
  }
  /// Adds the name `name`; fails if a file of that name exists.
  void link_to(const std::string& name, const std::string& path) const {
    if (::linkat(folder_, name_.c_str(), folder_, name.c_str(), 0) != 0) refuse(path, errno);
    ::fsync(folder_);
  }

 private:
  int folder_;
  std::string name_;
};

}  // namespace

void Beneath::add(const std::string& folder) {
  const std::string path = folder.ends_with('/') ? folder : folder + "/";
  if (std::ranges::any_of(folders_, [&](const Folder& one) { return one.path == path; })) return;
  io::Descriptor open(::open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (open.open()) folders_.push_back({path, std::move(open)});
}

io::Descriptor Beneath::open(const std::string& path, int flags) const {
  const Folder* nearest = nullptr;
  for (const Folder& one : folders_)
    if (path.starts_with(one.path) && (!nearest || one.path.size() > nearest->path.size())) nearest = &one;
  if (!nearest) refuse(path, "does not lie beneath the folders of this diagram and its parts");
  const std::string rest = path.substr(nearest->path.size());
  io::Descriptor opened = open_beneath(nearest->open.number(), rest.empty() ? "." : rest, flags);
  if (!opened.open() && (errno == EXDEV || errno == ELOOP))
    refuse(path, "a link on the way leads out of the folders of this diagram and its parts");
  if (!opened.open()) refuse(path, errno);
  return opened;
}

FileContent Beneath::read(const std::string& path) const {
  const io::Descriptor file = open(path, O_RDONLY | O_NONBLOCK);  // a pipe must not block
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) refuse(path, errno);
  if (!S_ISREG(status.st_mode)) refuse(path, "is no plain file");
  return {read_all(file.number(), path), status.st_mode};
}

bool Beneath::holds(const std::string& path) const {
  try {
    return open(path, O_PATH).open();
  } catch (const Fault&) {
    return false;
  }
}

bool Beneath::is_writable(const std::string& path) const {
  try {
    return open(path, O_WRONLY | O_NONBLOCK).open();
  } catch (const Fault&) {
    return false;
  }
}

void Beneath::replace(const std::string& path, std::string_view text) const {
  const fs::path file(path);
  const io::Descriptor old = open(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW);
  struct stat status {};
  if (::fstat(old.number(), &status) != 0) refuse(path, errno);
  if (!S_ISREG(status.st_mode)) refuse(path, "is no plain file");
  const io::Descriptor folder = open(file.parent_path().string() + "/", O_RDONLY | O_DIRECTORY);
  const FileBeside beside(folder.number(), io::temporary_beside(file.filename().string()));
  beside.write(text, status.st_mode, path);
  beside.rename_to(file.filename().string(), path);
}

void Beneath::create(const std::string& path, std::string_view text) const {
  const fs::path file(path), above = file.parent_path();
  if (!holds(above.string() + "/")) {
    const io::Descriptor folder = open(above.parent_path().string() + "/", O_RDONLY | O_DIRECTORY);
    if (::mkdirat(folder.number(), above.filename().c_str(), 0755) != 0) refuse(path, errno);
  }
  const io::Descriptor folder = open(file.parent_path().string() + "/", O_RDONLY | O_DIRECTORY);
  const FileBeside beside(folder.number(), io::temporary_beside(file.filename().string()));
  beside.write(text, 0644, path);
  beside.link_to(file.filename().string(), path);
}

}  // namespace stepwire::studio
