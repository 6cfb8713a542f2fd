#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::live {

/// Unnamed temporary file for chunks of numbers; the system removes it with the process. The space of
/// returned chunks is reused.
class SpillFile {
 public:
  /// `chunk`: numbers per chunk. Throws EnvironmentError if the folder is not writable.
  SpillFile(const std::string& folder, std::size_t chunk);

  /// Writes a chunk and returns its place. Throws EnvironmentError if less than 1 GiB of the disk is free.
  std::uint64_t write(std::span<const double> chunk);
  /// Reads numbers of a chunk from index `first` on, as many as fit into `into`. Throws EnvironmentError.
  void read(std::uint64_t place, std::size_t first, std::span<double> into) const;
  void give_back(std::uint64_t place) { free_.push_back(place); }
  /// Returns the size of the file in bytes.
  std::uint64_t size() const { return end_; }

 private:
  void leave_room() const;

  std::string folder_;
  std::size_t chunk_bytes_;
  io::Descriptor file_;
  std::uint64_t end_ = 0;
  std::vector<std::uint64_t> free_;
};

/// Minimum and maximum of some numbers; NaN is ignored. `least` exceeds `most` if there are none.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  bool none() const { return least > most; }
  void take(const Extremes& other) {
    if (other.least < least) least = other.least;
    if (other.most > most) most = other.most;
  }
};

/// Samples of one signal, one per tick from the first one on. All are on disk, the newest in memory, too. The
/// extremes of 64, 256, 1024, ... samples are in memory; they take a 24th of the samples' size. A missing
/// sample is NaN.
class SampleColumn {
 public:
  static constexpr std::int64_t chunk = 4096;  ///< ticks; each chunk starts at a multiple
  static constexpr std::int64_t block = 64;    ///< ticks of the lowest level of extremes
  static constexpr std::size_t factor = 4;     ///< blocks of a level in one of the next

  /// Keeps the last `in_memory` full chunks in memory; the number may change. It and the file must outlive
  /// the column.
  SampleColumn(SpillFile& file, std::int64_t first_tick, const std::size_t& in_memory);

  std::int64_t first_tick() const { return first_tick_; }
  /// Returns the tick after the last sample.
  std::int64_t end_tick() const { return sealed_end() + static_cast<std::int64_t>(filled_); }

  /// Appends `count` samples, `stride` numbers apart. Throws EnvironmentError.
  void append(const double* values, std::size_t count, std::size_t stride);
  /// Removes all samples from a tick on; if that is before the first one, the column starts there.
  void cut(std::int64_t tick);

  /// Returns the extremes of ticks begin, ..., end - 1.
  Extremes extremes(std::int64_t begin, std::int64_t end) const;
  /// Copies samples from a tick on, as many as fit into `into`; missing ones are NaN.
  void read(std::int64_t begin, std::span<double> into) const;
  /// Passes on the existing samples of these ticks, in contiguous parts, each with its first tick.
  template <class Take>
  void each_part(std::int64_t begin, std::int64_t end, const Take& take) const {
    begin = std::max(begin, first_tick_);
    end = std::min(end, end_tick());
    while (begin < end) {
      const std::int64_t next = std::min(end, (begin / chunk + 1) * chunk);
      take(begin, part(begin, static_cast<std::size_t>(next - begin)));
      begin = next;
    }
  }

 private:
  using Chunk = std::array<double, static_cast<std::size_t>(chunk)>;

  std::int64_t sealed_end() const { return base_ + static_cast<std::int64_t>(chunks_.size()) * chunk; }
  void start(std::int64_t tick);
  void seal();
  void raise(std::size_t level);
  /// Returns samples of one chunk; valid until the next call.
  std::span<const double> part(std::int64_t begin, std::size_t count) const;
  Extremes of_samples(std::int64_t begin, std::int64_t end) const;
  Extremes of_blocks(std::size_t begin, std::size_t end) const;

  SpillFile& file_;
  std::int64_t first_tick_ = 0, base_ = 0;  ///< ticks of the first sample and of its chunk
  const std::size_t& in_memory_;
  std::unique_ptr<Chunk> tail_ = std::make_unique<Chunk>();
  std::size_t filled_ = 0;                     ///< samples in the tail
  std::vector<std::uint64_t> chunks_;          ///< places of full chunks in the file
  std::deque<std::unique_ptr<Chunk>> recent_;  ///< the last full chunks
  std::vector<std::vector<Extremes>> levels_;  ///< of full chunks
  mutable std::unique_ptr<Chunk> read_;        ///< last chunk read
  mutable std::uint64_t read_index_ = UINT64_MAX;
};

}  // namespace stepwire::live
