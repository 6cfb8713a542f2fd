#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stepwire::language {

/// Malformed message frame.
class FrameError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reader of messages in a byte stream. Each message has a header with its length in bytes: "Content-Length:
/// 12\r\n\r\n".
class FrameReader {
 public:
  /// Reads at most `most` bytes and returns their count; 0 at the end of the stream.
  using Read = std::function<std::size_t(char* to, std::size_t most)>;

  explicit FrameReader(Read read) : read_(std::move(read)) {}

  /// Returns the next message; std::nullopt at the end of the stream. Throws FrameError for a header without
  /// a length, a message above 64 MB, and a stream that ends within a message.
  std::optional<std::string> next();

 private:
  bool fill();
  std::size_t take_header();

  Read read_;
  std::string buffer_;
};

/// Returns a message with its header.
std::string framed(std::string_view message);

}  // namespace stepwire::language
