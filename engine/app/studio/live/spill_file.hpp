#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::live {

/// A file without a name for chunks of numbers, which the system removes with the process. Chunks that are
/// given back are written anew.
class SpillFile {
 public:
  /// `chunk`: numbers in each. Throws EnvironmentError where the folder takes no file.
  SpillFile(const std::string& folder, std::size_t chunk);

  /// Where the chunk lies now. Throws EnvironmentError where the disk has less than 1 GiB left.
  std::uint64_t write(std::span<const double> chunk);
  /// As many numbers as `into` has, from the number `first` of a chunk on. Throws EnvironmentError.
  void read(std::uint64_t place, std::size_t first, std::span<double> into) const;
  void give_back(std::uint64_t place) { free_.push_back(place); }
  /// Bytes that lie on the disk.
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
