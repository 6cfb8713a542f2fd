#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stepwire::studio {

/// File of the page, compiled into the program.
struct PageFile {
  std::string_view path;  ///< path of its URL: "/assets/main-1a2b.js"
  std::string_view bytes;
  std::string_view packed;  ///< bytes compressed by gzip; empty if not packed
};

/// Returns all files of the page; an empty list if the program was built without npm.
std::span<const PageFile> page_table();

/// Placeholder in the page that each answer replaces by its nonce.
inline constexpr std::string_view nonce_mark = "STUDIO_NONCE";

/// Returns the content type for the ending of a path, such as "text/javascript; charset=utf-8".
std::string content_type(std::string_view path);

}  // namespace stepwire::studio
