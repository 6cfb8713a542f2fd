#include "engine/base/io/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::io {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

void make_folder_of(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error) refuse_file(path.parent_path().string(), error.value());
}

/// Writes all content or throws. Errors of buffered data appear only on flush or close.
void write_all(const std::string& path, const char* mode, std::string_view content,
               const std::string& shown) {
  File file(std::fopen(path.c_str(), mode));
  if (!file) refuse_file(shown, errno);
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size()) refuse_file(shown, errno);
  if (std::fflush(file.get()) != 0) refuse_file(shown, errno);
  if (std::fclose(file.release()) != 0) refuse_file(shown, errno);
}

/// Throws EnvironmentError for a pipe without a reader, whose opening would block.
void require_reader(const std::string& path) {
  const Descriptor pipe(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  if (!pipe.open()) refuse_file(path, errno);
}

void write_and_rename(const fs::path& target, std::string_view content, const std::string& shown) {
  const std::string temporary = temporary_beside(target.string());
  const Leftover leftover(temporary);
  try {
    write_all(temporary, "wbx", content, shown);
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error) refuse_file(shown, error.value());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

}  // namespace

std::string numbered(const std::string& stem, std::size_t index, const std::string& ending) {
  return index == 0 ? stem + ending : fmt::format("{}-{}{}", stem, index + 1, ending);
}

std::string temporary_beside(const std::string& path) {
  static std::atomic<unsigned long> count = 0;
  return fmt::format("{}.{}-{}.part", path, ::getpid(), count++);
}

void refuse_file(const std::string& path, int reason) {
  throw EnvironmentError(fmt::format("{}: {}", path, std::generic_category().message(reason)));
}

std::string read_file(const std::string& path) {
  require_inside(path);
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (fs::is_directory(status)) refuse_file(path, EISDIR);
  // A pipe would block, and a device may be endless.
  if (fs::is_other(status)) throw EnvironmentError(fmt::format("{}: this is no regular file", path));
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse_file(path, errno);
  std::string content;
  const std::uintmax_t size = fs::file_size(path, none);
  if (!none) content.reserve(size);  // avoids reallocation, which needs twice the memory
  std::string block(1 << 16, '\0');
  for (std::size_t got = 1; got > 0;) {
    got = std::fread(block.data(), 1, block.size(), file.get());
    content.append(block, 0, got);
  }
  if (std::ferror(file.get())) refuse_file(path, errno);
  return content;
}

void require_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) refuse_file(path, error.value());
  if (!fs::is_directory(path, error)) refuse_file(path, ENOTDIR);
  if (::access(path.c_str(), W_OK | X_OK) != 0) refuse_file(path, errno);
}

void write_file(const std::string& path, std::string_view content) {
  make_folder_of(path);
  // A link is kept and its target replaced. Special files such as /dev/stdout cannot be replaced and are
  // written directly.
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) refuse_file(path, error.value());
  const fs::file_status status = fs::status(target, error);
  if (fs::is_fifo(status)) require_reader(path);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_all(path, "wb", content, path);
  note_written(path);
  write_and_rename(target, content, path);
}

}  // namespace stepwire::io
