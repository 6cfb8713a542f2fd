#include "engine/base/io/atomic_file_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::io {

namespace fs = std::filesystem;

AtomicFileWriter::AtomicFileWriter(const std::string& path)
    : path_(path), temporary_(temporary_beside(path)), leftover_(temporary_) {
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) refuse_file(folder.string(), error.value());
  note_written(path);
  file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) refuse_file(path_, errno);
}

AtomicFileWriter::~AtomicFileWriter() {
  if (file_ < 0) return;
  ::close(file_);
  if (published_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFileWriter::append(std::string_view piece) {
  if (try_append(piece)) return;
  incomplete_ = true;
  throw EnvironmentError(trouble_);
}

bool AtomicFileWriter::try_append(std::string_view piece) {
  if (write_all(piece)) {
    size_ += static_cast<std::int64_t>(piece.size());
    return true;
  }
  if (trouble_.empty()) trouble_ = fmt::format("{}: {}", path_, std::generic_category().message(errno));
  // Removes the incomplete piece, so that the next one does not follow half a row.
  if (::ftruncate(file_, size_) == 0) ::lseek(file_, size_, SEEK_SET);
  return false;
}

bool AtomicFileWriter::write_all(std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t written = ::write(file_, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) return false;
    piece.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void AtomicFileWriter::publish() noexcept {
  published_ = published_ || ::rename(temporary_.c_str(), path_.c_str()) == 0;
}

void AtomicFileWriter::finish() {
  if (incomplete_) throw EnvironmentError(trouble_);
  const int file = std::exchange(file_, -1);
  const bool closed = ::close(file) == 0;
  const int reason = errno;
  std::error_code error;
  if (closed && !published_) fs::rename(temporary_, path_, error);
  if (closed && !error) return;
  std::error_code ignored;
  if (!published_) fs::remove(temporary_, ignored);
  refuse_file(path_, closed ? error.value() : reason);
}

}  // namespace stepwire::io
