#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace stepwire::live
