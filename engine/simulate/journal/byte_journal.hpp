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

/// File of results of numbered pieces of work. Each is stored as soon as it exists, so that a killed call can
/// continue and several calls can share the work.
///
/// The file is a line of text that identifies the inputs of the results, and a record for each piece in order
/// of completion. A record is its length, a checksum, and its bytes, which begin with the number of the piece
/// (8 bytes). Many records within half a second are written together. A record that was cut off by the end of
/// its process is ignored.
class ByteJournal {
 public:
  /// Returns the first line of a journal; std::nullopt for any other file. Throws EnvironmentError.
  static std::optional<std::string> head_of(const std::string& path);

  enum class Use { read, write };
  /// Opens a journal of `pieces` pieces; for writing, creates it if needed. `head` is one line; a file with
  /// another head is replaced. Throws EnvironmentError.
  ByteJournal(std::string path, const std::string& head, std::size_t pieces, Use use);
  ~ByteJournal();
  ByteJournal(const ByteJournal&) = delete;
  ByteJournal& operator=(const ByteJournal&) = delete;

  bool has(std::size_t piece) const { return places_[piece] != missing; }
  /// Returns the number of stored pieces.
  std::size_t count() const { return count_; }
  /// Adds the bytes of a piece, which begin with its number. Thread-safe. Throws EnvironmentError.
  void add_bytes(std::size_t piece, std::string_view bytes) { add_record(piece, record_of(bytes)); }
  /// Returns the record of such bytes, which another process may compute. add_record() adds it.
  static std::string record_of(std::string_view bytes);
  void add_record(std::size_t piece, std::string_view record);
  /// Writes all added records to the file.
  void flush();
  /// Returns the bytes of a piece; std::nullopt if it is missing, and no bytes if the file was damaged after
  /// it was opened. After follow(), waits for missing pieces. Thread-safe.
  std::optional<std::string> bytes(std::size_t piece);
  /// Makes bytes() wait for pieces that other threads add, until end_following().
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
  std::uint64_t end_ = 0;  ///< end of the file [bytes]
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::vector<std::uint64_t> places_;  ///< place of each piece's record in the file
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace stepwire::journal
