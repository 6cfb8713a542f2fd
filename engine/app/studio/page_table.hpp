#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stepwire::studio {

/// A file of the page, compiled in.
struct PageFile {
  std::string_view path;  ///< of the address: "/assets/main-1a2b.js"
  std::string_view bytes;
  std::string_view packed;  ///< the same by gzip; empty where that is not shorter
};

/// All files of the page; none where the program was built without npm.
std::span<const PageFile> page_table();

/// What stands in the page where the nonce of an answer goes.
inline constexpr std::string_view nonce_mark = "STUDIO_NONCE";

/// "text/javascript; charset=utf-8" of a path's ending.
std::string content_type(std::string_view path);

}  // namespace stepwire::studio
