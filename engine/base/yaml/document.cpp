#include "engine/base/yaml/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "engine/base/io/inside.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/near_file.hpp"
#include "engine/base/yaml/yaml_reader.hpp"

namespace stepwire::yaml {
namespace {

/// Location of invalid text, and the message about it.
struct TextFault {
  Mark mark;
  std::string message;
};

bool is_plain(unsigned char c) {
  return (c >= 0x20 && c < 0x7f) || c == '\n' || c == '\t';
}

Mark mark_at(std::string_view text, std::size_t position) {
  Mark mark{1, 1};
  for (std::size_t i = 0; i < position; i += std::max<std::size_t>(1, text::utf8_length(text.substr(i)))) {
    ++mark.column;
    if (text[i] == '\n') mark = {mark.line + 1, 1};
  }
  return mark;
}

std::string message_for(unsigned char c) {
  if (c == '\r')
    return "a carriage return without a line feed; save the file with line ends of Unix or Windows";
  if (c == 0) return "a NUL byte; this is no text file (or it is UTF-16: save it as UTF-8)";
  if (c == 0xfe || c == 0xff) return fmt::format("the byte 0x{:02x} is no UTF-8; save the file as UTF-8", c);
  if (c < 0x80) return fmt::format("the control character 0x{:02x} cannot stand in a YAML file", c);
  return fmt::format("the byte 0x{:02x} is no UTF-8 here; save the file as UTF-8", c);
}

/// Returns the first byte that YAML does not allow, a control character or invalid UTF-8; std::nullopt for a
/// valid text.
std::optional<TextFault> check_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    // A lone carriage return is refused: the YAML library does not treat it as a line end, so all text would
    // be one line.
    const bool line_end = c == '\r' && text.substr(i + 1).starts_with('\n');
    const std::size_t length = is_plain(c) || line_end ? 1 : c < 0x80 ? 0 : text::utf8_length(text.substr(i));
    if (length == 0) return TextFault{mark_at(text, i), message_for(c)};
    i += length;
  }
  return std::nullopt;
}

[[noreturn]] void fail(const std::string& file, Mark mark, Message message) {
  throw Error(Fault{.place = {file, mark}, .subject = "", .message = std::move(message), .used_by = {}});
}

std::string megabytes(std::uintmax_t bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / (1 << 20));
}

void check_size(std::uintmax_t size, const std::string& file, const DocumentLimits& limits) {
  if (size <= limits.bytes) return;
  fail(file, {},
       fmt::format("the file has {}, and at most {} are read", megabytes(size), megabytes(limits.bytes)));
}

// Reads a file up to the limit. The size is checked first; reading checks it again, since the file may grow.
std::string contents(const std::string& path, const DocumentLimits& limits) {
  if (!io::is_inside(path)) fail(path, {}, "this file is outside of the folder of the call; name one inside");
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  if (std::filesystem::is_directory(status)) fail(path, {}, "this is a folder, not a file");
  // A pipe would block, and a device may be endless.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    fail(path, {}, "this is no regular file; write the diagram into one");
  if (std::filesystem::is_regular_file(status))
    check_size(std::filesystem::file_size(path, none), path, limits);

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file && errno == ENOENT) fail(path, {}, "no such file" + near_file(path));
  if (!file) fail(path, {}, fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string text;
  char chunk[1 << 16];
  while (const std::size_t read = std::fread(chunk, 1, sizeof chunk, file.get())) {
    text.append(chunk, read);
    check_size(text.size(), path, limits);
  }
  if (std::ferror(file.get())) fail(path, {}, fmt::format("cannot be read: {}", std::strerror(errno)));
  return text;
}

}  // namespace

const Node* Node::find(std::string_view key) const {
  const auto at =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
  return at == entries.end() ? nullptr : &at->value;
}

Document parse_document(std::string_view text, const std::string& file, const DocumentLimits& limits) {
  check_size(text.size(), file, limits);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (const auto wrong = check_text(text)) fail(file, wrong->mark, wrong->message);
  return {file, read_yaml(text, file, limits)};
}

Document read_document(const std::string& path, const DocumentLimits& limits) {
  return parse_document(contents(path, limits), path, limits);
}

}  // namespace stepwire::yaml
