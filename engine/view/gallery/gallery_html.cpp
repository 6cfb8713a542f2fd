#include "engine/view/gallery/gallery_html.hpp"

#include <filesystem>
#include <string_view>

#include "engine/view/svg/svg.hpp"

namespace stepwire::gallery {

std::string html_piece(const Html& html) {
  return html.code;
}

std::string html_piece(const std::string& text) {
  return svg::markup_escaped(text);
}

std::string html_piece(const Address& address) {
  std::string result;
  for (const char c : address.path) {
    if (std::string_view(" #?%\"<>").find(c) != std::string_view::npos)
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return svg::markup_escaped(result);
}

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

Address address_from(const std::string& page, const std::string& target) {
  namespace fs = std::filesystem;
  return {fs::path(target).lexically_relative(fs::path(page).parent_path()).generic_string()};
}

std::string framed(const GalleryFrame& frame, const Html& content) {
  const Html head = html(R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{}">
<script src="{}" defer></script>
{})",
                         frame.title, address_from(frame.page, "gallery.css"),
                         address_from(frame.page, "gallery.js"), frame.links);
  return html(R"(<!DOCTYPE html>
<html lang="en">
<head>
{}</head>
<body class="{}">
<a class="skip" href="#content">To the content</a>
{}<main id="content" tabindex="-1">
{}</main>
</body>
</html>
)",
              head, frame.look, frame.navigation, content)
      .code;
}

}  // namespace stepwire::gallery
