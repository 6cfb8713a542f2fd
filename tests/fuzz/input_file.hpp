#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace stepwire::fuzz {

/// File in memory for a reader that takes a path. It has the same path in all calls of one process.
class InputFile {
 public:
  explicit InputFile(const std::string& extension)
      : path_("/dev/shm/stepwire-fuzz-" + std::to_string(::getpid()) + extension) {}
  ~InputFile() { std::filesystem::remove(path_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Replaces the content, and returns the path.
  const std::string& with(const std::uint8_t* data, std::size_t size) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_;
  }

 private:
  const std::string path_;
};

}  // namespace stepwire::fuzz
