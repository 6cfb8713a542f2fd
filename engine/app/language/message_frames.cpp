#include "engine/app/language/message_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace stepwire::language {

namespace {

constexpr std::size_t longest_header = 4096;
constexpr std::size_t longest_message = 64u << 20;

std::size_t length_in(std::string_view header) {
  constexpr std::string_view name = "content-length:";
  std::string lower(header);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t at = lower.starts_with(name) ? 0 : lower.find(std::string("\n") + std::string(name));
  if (at == std::string::npos)
    throw FrameError("a message begins with 'Content-Length:', its length in bytes");
  const std::size_t digits = lower.find_first_of("0123456789\n", lower.find(':', at));
  std::size_t length = 0;
  const auto read =
      std::from_chars(lower.data() + std::min(digits, lower.size()), lower.data() + lower.size(), length);
  if (read.ec != std::errc{} || length > longest_message)
    throw FrameError("'Content-Length:' has no number of bytes up to 64 MB");
  return length;
}

}  // namespace

bool FrameReader::fill() {
  char chunk[1 << 14];
  const std::size_t count = read_(chunk, sizeof chunk);
  buffer_.append(chunk, count);
  return count > 0;
}

std::size_t FrameReader::take_header() {
  constexpr std::string_view end = "\r\n\r\n";
  for (std::size_t at = buffer_.find(end);; at = buffer_.find(end)) {
    if (at != std::string::npos) {
      const std::size_t length = length_in(std::string_view(buffer_).substr(0, at + 2));
      buffer_.erase(0, at + end.size());
      return length;
    }
    if (buffer_.size() > longest_header) throw FrameError("the header of a message does not end");
    if (!fill()) throw FrameError("the stream ends inside of the header of a message");
  }
}

std::optional<std::string> FrameReader::next() {
  if (buffer_.empty() && !fill()) return std::nullopt;
  const std::size_t length = take_header();
  while (buffer_.size() < length)
    if (!fill()) throw FrameError("the stream ends inside of a message");
  std::string message = buffer_.substr(0, length);
  buffer_.erase(0, length);
  return message;
}

std::string framed(std::string_view message) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
}

}  // namespace stepwire::language
