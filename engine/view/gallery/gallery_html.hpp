#pragma once

#include <fmt/format.h>

#include <string>

namespace stepwire::gallery {

/// HTML as it is written. A text becomes HTML by html() alone, which escapes it.
struct Html {
  std::string code;

  bool empty() const { return code.empty(); }
  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
};

/// A path, relative to the page on which it stands: what has a meaning in an address is written as its code.
struct Address {
  std::string path;
};

std::string html_piece(const Html& html);
std::string html_piece(const std::string& text);
inline std::string html_piece(const char* text) {
  return html_piece(std::string(text));
}
std::string html_piece(const Address& address);
inline std::string html_piece(std::size_t number) {
  return fmt::format("{}", number);
}

/// A template filled with pieces, at each {}: HTML as it is, texts and addresses escaped.
template <typename... Pieces>
Html html(fmt::string_view form, const Pieces&... pieces) {
  return {fmt::format(fmt::runtime(form), html_piece(pieces)...)};
}

/// "1 value", "2 values".
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// The address of one place of the gallery on a page at another.
Address address_from(const std::string& page, const std::string& target);

/// What a page of the gallery has around its content.
struct GalleryFrame {
  std::string page;       ///< its place in the gallery: "fig15-map/index.html"
  std::string title;      ///< of the window
  Html navigation{};      ///< ahead of the content
  Html links{};           ///< of its head
  std::string look = "";  ///< class of its body
};

/// The whole page.
std::string framed(const GalleryFrame& frame, const Html& content);

}  // namespace stepwire::gallery
