#pragma once

#include <fmt/format.h>

#include <string>

namespace stepwire::gallery {

/// HTML text. Only html() converts other texts to HTML; it escapes them.
struct Html {
  std::string code;

  bool empty() const { return code.empty(); }
  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
};

/// Path relative to the page that contains it; special characters are percent-encoded.
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

/// Fills the placeholders {} of a template: HTML is copied, texts and addresses are escaped.
template <typename... Pieces>
Html html(fmt::string_view form, const Pieces&... pieces) {
  return {fmt::format(fmt::runtime(form), html_piece(pieces)...)};
}

/// Returns "1 value", "2 values".
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// Returns the address of one path of the gallery on the page of another.
Address address_from(const std::string& page, const std::string& target);

/// Frame of a page of the gallery around its content.
struct GalleryFrame {
  std::string page;       ///< path in the gallery: "fig15-map/index.html"
  std::string title;      ///< title of the window
  Html navigation{};      ///< before the content
  Html links{};           ///< links of the head
  std::string look = "";  ///< CSS class of the body
};

/// Returns the whole page.
std::string framed(const GalleryFrame& frame, const Html& content);

}  // namespace stepwire::gallery
