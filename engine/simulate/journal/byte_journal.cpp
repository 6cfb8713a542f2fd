#include "engine/simulate/journal/byte_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::journal {

namespace {

constexpr std::string_view mark = "stepwire points 1 ";
constexpr std::size_t longest_head = std::size_t{1} << 20;
constexpr std::size_t most_waiting = std::size_t{1} << 20;
constexpr std::chrono::milliseconds longest_wait{500};
constexpr std::size_t sum_size = 16;
constexpr std::size_t record_head = sizeof(std::uint64_t) + sum_size;

std::string sum_of(std::string_view bytes) {
  return hash::hash_of(bytes).substr(0, sum_size);
}

/// Memory map of a file at its present size, read on demand.
class Mapped {
 public:
  Mapped(int file, const std::string& path) {
    struct stat state {};
    if (::fstat(file, &state) != 0) io::refuse_file(path, errno);
    size_ = static_cast<std::size_t>(state.st_size);
    if (size_ == 0) return;
    void* const start = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, file, 0);
    if (start == MAP_FAILED) io::refuse_file(path, errno);
    start_ = static_cast<const char*>(start);
  }
  ~Mapped() {
    if (start_) ::munmap(const_cast<char*>(start_), size_);
  }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;

  std::string_view bytes() const { return {start_, size_}; }

  /// Counts the bytes that were read and unmaps their pages after some MB, so that a large file does not stay
  /// in memory.
  void note_seen(std::size_t bytes) const {
    constexpr std::size_t most = std::size_t{16} << 20, least = 4096;  // at least one page per piece
    seen_ += std::max(bytes, least);
    if (seen_ < most) return;
    ::madvise(const_cast<char*>(start_), size_, MADV_DONTNEED);
    seen_ = 0;
  }

 private:
  const char* start_ = nullptr;
  std::size_t size_ = 0;
  mutable std::size_t seen_ = 0;
};

/// Returns the first line with its line end; an empty text if the file is no journal.
std::string_view first_line(std::string_view file) {
  const std::size_t end = file.substr(0, longest_head).find('\n');
  return end == file.npos || !file.starts_with(mark) ? "" : file.substr(0, end + 1);
}

/// Returns the bytes of the record at a place; std::nullopt if there is no complete record.
std::optional<std::string_view> record_at(std::string_view file, std::uint64_t place) {
  if (place > file.size() || file.size() - place < record_head) return std::nullopt;
  std::uint64_t size = 0;
  std::memcpy(&size, file.data() + place, sizeof(size));
  const std::string_view sum = file.substr(place + sizeof(size), sum_size);
  if (size > file.size() - place - record_head) return std::nullopt;
  const std::string_view bytes = file.substr(place + record_head, size);
  if (sum_of(bytes) != sum) return std::nullopt;
  return bytes;
}

}  // namespace

std::optional<std::string> ByteJournal::head_of(const std::string& path) {
  const io::Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (!file.open()) {
    if (errno == ENOENT) return std::nullopt;
    io::refuse_file(path, errno);
  }
  const Mapped mapped(file.number(), path);
  const std::string_view line = first_line(mapped.bytes());
  if (line.empty()) return std::nullopt;
  return std::string(line.substr(mark.size(), line.size() - mark.size() - 1));
}

ByteJournal::ByteJournal(std::string path, const std::string& head, std::size_t pieces, Use use)
    : path_(std::move(path)), places_(pieces, missing) {
  const int how = use == Use::read ? O_RDONLY : O_RDWR | O_CREAT;
  file_ = io::Descriptor(::open(path_.c_str(), how | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (!file_.open()) io::refuse_file(path_, errno);
  const std::string line = fmt::format("{}{}\n", mark, head);
  const bool is_known = first_line(Mapped(file_.number(), path_).bytes()) == line;
  if (is_known) find_pieces(line.size());
  if (use == Use::read) return;
  if (::ftruncate(file_.number(), static_cast<off_t>(end_)) != 0) io::refuse_file(path_, errno);
  if (is_known) return;
  waiting_ = line;
  write_waiting();
}

ByteJournal::~ByteJournal() {
  try {
    flush();
  } catch (const std::exception&) {  // pieces that are not in the file are run again
  }
}

/// Indexes all records up to the first incomplete one.
void ByteJournal::find_pieces(std::uint64_t first) {
  const Mapped mapped(file_.number(), path_);
  end_ = first;
  while (const auto bytes = record_at(mapped.bytes(), end_)) {
    mapped.note_seen(bytes->size());
    std::uint64_t piece = 0;
    if (bytes->size() < sizeof(piece)) return;
    std::memcpy(&piece, bytes->data(), sizeof(piece));
    if (piece >= places_.size()) return;
    if (!has(piece)) ++count_;
    places_[piece] = end_;
    end_ += record_head + bytes->size();
  }
}

std::string ByteJournal::record_of(std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  std::string record(reinterpret_cast<const char*>(&size), sizeof(size));
  return record.append(sum_of(bytes)).append(bytes);
}

void ByteJournal::add_record(std::size_t piece, std::string_view record) {
  const std::lock_guard lock(mutex_);
  if (has(piece)) return;
  places_[piece] = end_ + waiting_.size();
  ++count_;
  waiting_.append(record);
  added_.notify_all();
  if (waiting_.size() >= most_waiting || std::chrono::steady_clock::now() - written_ >= longest_wait)
    write_waiting();
}

void ByteJournal::flush() {
  const std::lock_guard lock(mutex_);
  write_waiting();
}

void ByteJournal::write_waiting() {
  std::size_t done = 0;
  while (done < waiting_.size()) {
    const ssize_t written = ::pwrite(file_.number(), waiting_.data() + done, waiting_.size() - done,
                                     static_cast<off_t>(end_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) io::refuse_file(path_, written < 0 ? errno : EIO);
    done += static_cast<std::size_t>(written);
  }
  end_ += waiting_.size();
  waiting_.clear();
  written_ = std::chrono::steady_clock::now();
}

void ByteJournal::follow() {
  const std::lock_guard lock(mutex_);
  followed_ = true;
}

void ByteJournal::end_following() {
  const std::lock_guard lock(mutex_);
  followed_ = false;
  added_.notify_all();
}

/// Reads the record at a place; a shorter text if the file ends before it.
std::string ByteJournal::bytes_at(std::uint64_t place, std::uint64_t end) const {
  std::string bytes(record_head, '\0');
  std::uint64_t size = 0;
  const auto fill = [&](std::size_t from) {
    while (from < bytes.size()) {
      const ssize_t got =
          ::pread(file_.number(), bytes.data() + from, bytes.size() - from, static_cast<off_t>(place + from));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) io::refuse_file(path_, errno);
      if (got == 0) return bytes.resize(from);
      from += static_cast<std::size_t>(got);
    }
  };
  fill(0);
  if (bytes.size() < record_head) return bytes;
  std::memcpy(&size, bytes.data(), sizeof(size));
  if (size > end - place) return bytes;
  bytes.resize(record_head + size);
  fill(record_head);
  return bytes;
}

std::optional<std::string> ByteJournal::bytes(std::size_t piece) {
  std::unique_lock lock(mutex_);
  added_.wait(lock, [&] { return has(piece) || !followed_; });
  if (!has(piece)) return std::nullopt;
  if (places_[piece] >= end_) write_waiting();
  const std::uint64_t place = places_[piece], end = end_;
  lock.unlock();
  const std::string record = bytes_at(place, end);
  return std::string(record_at(record, 0).value_or(""));
}

}  // namespace stepwire::journal
