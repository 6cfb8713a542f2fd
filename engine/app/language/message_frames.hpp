#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stepwire::language {

/// What comes over a pipe and is no message.
class FrameError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes messages out of a stream of bytes, each behind a header with its length in bytes: "Content-Length:
/// 12\r\n\r\n".
class FrameReader {
 public:
  /// Puts at most so many bytes at a place and returns how many; 0 at the end of the stream.
  using Read = std::function<std::size_t(char* to, std::size_t most)>;

  explicit FrameReader(Read read) : read_(std::move(read)) {}

  /// The next message; nothing at the end of the stream. Throws FrameError for what has no header with a
  /// length, for a message above 64 MB, and where the stream ends inside of one.
  std::optional<std::string> next();

 private:
  bool fill();
  std::size_t take_header();

  Read read_;
  std::string buffer_;
};

/// A message with its header.
std::string framed(std::string_view message);

}  // namespace stepwire::language
