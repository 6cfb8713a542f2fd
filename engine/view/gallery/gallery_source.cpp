#include "engine/view/gallery/gallery_page.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>

namespace stepwire::gallery {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// True for a letter of a word. Bytes beyond ASCII are letters, so that no UTF-8 sequence is split.
bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Colours a text line by line. The state that extends over lines, a quoted text or a block of text, is
/// stored.
class YamlPainter {
 public:
  explicit YamlPainter(const PartAddress& part) : part_(part) {}

  Html paint(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      paint_line(line);
      result_.code += '\n';
    }
    return std::move(result_);
  }

 private:
  void paint_line(std::string_view line) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (block_ && (indent == line.size() || indent > *block_)) return add("string", line);
    block_.reset();
    line_ = line;
    at_ = 0;
    key_.clear();
    while (at_ < line_.size()) step();
    if (opens_block()) block_ = indent;
  }

  void step() {
    const char c = line_[at_];
    if (quote_ != 0 || c == '"' || c == '\'')
      quoted();
    else if (c == '#' && (at_ == 0 || line_[at_ - 1] == ' '))
      take("comment", line_.size());
    else if (c == ' ' || std::string_view(",{}[]").find(c) != std::string_view::npos)
      mark();
    else
      plain();
  }

  void mark() {
    if (line_[at_] == ',') key_.clear();
    take("", at_ + 1);
  }

  void quoted() {
    std::size_t end = at_ + (quote_ == 0 ? 1 : 0);
    if (quote_ == 0) quote_ = line_[at_];
    for (; end < line_.size() && line_[end] != quote_; ++end)
      if (quote_ == '"' && line_[end] == '\\') ++end;
    const bool closed = end < line_.size();
    if (closed) quote_ = 0;
    take("string", closed ? end + 1 : line_.size());
  }

  /// Colours a key with its colon, or an unquoted value up to its end.
  void plain() {
    std::size_t end = at_;
    while (end < line_.size() && !ends_plain(end)) ++end;
    const bool is_key = end < line_.size() && line_[end] == ':';
    if (!is_key) return value(end);
    key_ = line_.substr(at_, end - at_);
    if (key_.starts_with("- ")) key_.erase(0, 2);
    take("key", end);
    take("", end + 1);
  }

  bool ends_plain(std::size_t at) const {
    const char c = line_[at];
    if (c == ':') return at + 1 == line_.size() || line_[at + 1] == ' ';
    if (c == '#') return at > 0 && line_[at - 1] == ' ';
    return std::string_view(",{}[]").find(c) != std::string_view::npos;
  }

  void value(std::size_t end) {
    if (key_ == "block") return take("type", end);
    if (key_ == "diagram") return reference(end);
    while (at_ < end) token(end);
  }

  void reference(std::size_t end) {
    const std::string path(line_.substr(at_, end - at_));
    const Address address = part_(path);
    if (address.path.empty()) return take("", end);
    result_ += html("<a href=\"{}\">{}</a>", address, path);
    at_ = end;
  }

  /// Colours a name of a parameter, a number, a word, or one sign between them.
  void token(std::size_t end) {
    const char c = line_[at_];
    std::size_t stop = at_ + 1;
    if (is_digit(c)) {
      while (stop < end && (is_of_word(line_[stop]) || line_[stop] == '.' || signs_exponent(stop))) ++stop;
      return take("number", stop);
    }
    if (c != '$' && !is_of_word(c)) return take("", stop);
    while (stop < end && (is_of_word(line_[stop]) || line_[stop] == '.')) ++stop;
    take(c == '$' ? "name" : "", stop);
  }

  bool signs_exponent(std::size_t at) const {
    return (line_[at] == '-' || line_[at] == '+') && (line_[at - 1] == 'e' || line_[at - 1] == 'E');
  }

  bool opens_block() const {
    const std::size_t last = line_.find_last_not_of(" -+");
    if (quote_ != 0 || last == std::string_view::npos || last < 2) return false;
    return (line_[last] == '>' || line_[last] == '|') && line_.substr(0, last).ends_with(": ");
  }

  void take(const char* look, std::size_t end) {
    add(look, line_.substr(at_, end - at_));
    at_ = end;
  }

  void add(const std::string& look, std::string_view text) {
    const std::string piece(text);
    result_ += look.empty() ? html("{}", piece) : html("<span class=\"{}\">{}</span>", look, piece);
  }

  const PartAddress& part_;
  Html result_;
  std::string_view line_;
  std::size_t at_ = 0;
  std::string key_;                     ///< key of the next value
  char quote_ = 0;                      ///< quote of an unfinished text
  std::optional<std::size_t> block_{};  ///< indentation of the key of a block of text
};

namespace fs = std::filesystem;

std::string file_name(const std::string& path) {
  return fs::path(path).filename().string();
}

bool uses(const GalleryEntry& entry, const std::string& path) {
  return std::ranges::any_of(entry.sources, [&](const GallerySource& source) { return source.path == path; });
}

Html users_of(const Gallery& gallery, const std::string& path, const std::string& page) {
  Html links;
  for (const GalleryEntry& entry : gallery.entries)
    if (uses(entry, path))
      links += html("{}<a href=\"{}\">{}</a>", links.empty() ? "" : ", ", address_from(page, page_of(entry)),
                    short_name(entry));
  return html("<p>Used by {}.</p>\n", links);
}

}  // namespace

Html painted_yaml(const std::string& text, const PartAddress& part) {
  return YamlPainter(part).paint(text);
}

GallerySources sources_of(const Gallery& gallery) {
  GallerySources sources;
  for (const GalleryEntry& entry : gallery.entries)
    for (const GallerySource& source : entry.sources) sources[source.path] = source.text;
  return sources;
}

std::string page_of_source(const std::string& path) {
  return path + ".html";
}

Html painted_source(const std::string& page, const std::string& path, const GallerySources& sources) {
  const PartAddress part = [&](const std::string& written) {
    const std::string target = (fs::path(path).parent_path() / written).lexically_normal().generic_string();
    return sources.contains(target) ? address_from(page, page_of_source(target)) : Address{};
  };
  return html("<pre class=\"yaml\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><code>{}</code></pre>\n",
              file_name(path), painted_yaml(sources.at(path), part));
}

std::string source_page(const Gallery& gallery, const GallerySources& sources, const std::string& path) {
  const std::string page = page_of_source(path);
  GalleryFrame frame{.page = page, .title = file_name(path), .look = "source"};
  const Address up = address_from(page, "index.html");
  frame.navigation =
      html("<nav class=\"bar\" aria-label=\"Gallery\"><a rel=\"up\" href=\"{}\">All figures</a></nav>\n", up);
  const Html head = html("<h1>{}</h1>\n<p><a href=\"{}\" download>Download {}</a></p>\n", file_name(path),
                         Address{file_name(path)}, file_name(path));
  return framed(frame,
                html("{}{}{}", head, users_of(gallery, path, page), painted_source(page, path, sources)));
}

}  // namespace stepwire::gallery
