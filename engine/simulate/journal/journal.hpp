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
#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::journal {

/// Results of the points of a sweep in a file, each kept as soon as it is there (those of the last half
/// second, if they are many, together), so that a call that was killed goes on and several calls share the
/// points. The file is a line of text that says what its points follow from, and a record for each point, in
/// the order in which they ended: its length, a checksum, and its bytes. A record that was cut off by the end
/// of its process is none.
class Journal {
 public:
  /// The first line of a journal; nothing where the file is none. Throws EnvironmentError.
  static std::optional<std::string> head_of(const std::string& path);

  enum class Use { read, write };
  /// Opens a journal of a job whose sweep keeps these numbers (null: rows), to write also makes it; `head` is
  /// one line, and what is there with another one is replaced. Job and numbers must outlive it. Throws
  /// EnvironmentError.
  Journal(std::string path, const std::string& head, const run::Job& job, const run::RunNumbers* numbers,
          Use use);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::size_t point) const { return places_[point] != missing; }
  /// Points that it has.
  std::size_t count() const { return count_; }
  /// Adds a point, or its bytes_of(). From any thread. Throws EnvironmentError.
  void add(const run::PointResult& result);
  void add_bytes(std::size_t point, std::string_view bytes);
  /// Hands all that was added to the system.
  void flush();
  /// What it has of a point; nothing where it has not. While it is followed, waits for what is not there yet.
  /// From any thread. Throws EnvironmentError where the file was damaged since it was opened.
  std::optional<run::PointResult> point(std::size_t point);
  /// From now on, point() waits for points that are added on other threads; until they have ended.
  void follow();
  void end_following();
  const std::string& path() const { return path_; }

 private:
  static constexpr std::uint64_t missing = ~std::uint64_t{0};

  void find_points(std::uint64_t first);
  std::string bytes_at(std::uint64_t place, std::uint64_t end) const;
  void write_waiting();

  const std::string path_;
  const run::Job& job_;
  const run::RunNumbers* numbers_;
  io::Descriptor file_;
  std::mutex mutex_;
  std::condition_variable added_;
  bool followed_ = false;
  std::string waiting_;    ///< records that are not in the file yet
  std::uint64_t end_ = 0;  ///< of the file [bytes]
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::vector<std::uint64_t> places_;  ///< of each point's record in the file
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace stepwire::journal
