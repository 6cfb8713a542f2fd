#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::journal {

/// Results of numbered pieces of work in a file, each kept as soon as it is there (those of the last half
/// second, if they are many, together), so that a call that was killed goes on and several calls share the
/// work. The file is a line of text that says what its results follow from, and a record for each piece, in
/// the order in which they ended: its length, a checksum, and its bytes, which begin with its number (8
/// bytes). A record that was cut off by the end of its process is none.
class ByteJournal {
 public:
  /// The first line of a journal; nothing where the file is none. Throws EnvironmentError.
  static std::optional<std::string> head_of(const std::string& path);

  enum class Use { read, write };
  /// Opens a journal of so many pieces, to write also makes it; `head` is one line, and what is there with
  /// another one is replaced. Throws EnvironmentError.
  ByteJournal(std::string path, const std::string& head, std::size_t pieces, Use use);
  ~ByteJournal();
  ByteJournal(const ByteJournal&) = delete;
  ByteJournal& operator=(const ByteJournal&) = delete;

  bool has(std::size_t piece) const { return places_[piece] != missing; }
  /// Pieces that it has.
  std::size_t count() const { return count_; }
  /// Adds the bytes of a piece, which begin with its number. From any thread. Throws EnvironmentError.
  void add_bytes(std::size_t piece, std::string_view bytes) { add_record(piece, record_of(bytes)); }
  /// The record of such bytes, which another process may make; adds it.
  static std::string record_of(std::string_view bytes);
  void add_record(std::size_t piece, std::string_view record);
  /// Hands all that was added to the system.
  void flush();
  /// The bytes of a piece; nothing where it has none, and no bytes where the file was damaged since it was
  /// opened. While it is followed, waits for what is not there yet. From any thread.
  std::optional<std::string> bytes(std::size_t piece);
  /// From now on, bytes() waits for pieces that are added on other threads; until they have ended.
  void follow();
  void end_following();
  const std::string& path() const { return path_; }

 private:
  static constexpr std::uint64_t missing = ~std::uint64_t{0};

  void find_pieces(std::uint64_t first);
  std::string bytes_at(std::uint64_t place, std::uint64_t end) const;
  void write_waiting();

  const std::string path_;
  io::Descriptor file_;
  std::mutex mutex_;
  std::condition_variable added_;
  bool followed_ = false;
  std::string waiting_;    ///< records that are not in the file yet
  std::uint64_t end_ = 0;  ///< of the file [bytes]
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::vector<std::uint64_t> places_;  ///< of each piece's record in the file
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace stepwire::journal
