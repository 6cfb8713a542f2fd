#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::render {

/// Entry of the outline of a PDF file.
struct Bookmark {
  std::string title;     ///< UTF-8
  std::size_t page = 1;  ///< counted from 1
};

/// Returns the PDF file with an outline, added as an incremental update at the end of the file (PDF 1.7,
/// 7.5.6). Only a file with a plain object table is changed, as written by Cairo 1.16. Any other file, or one
/// without the page of a bookmark, is returned unchanged.
std::string with_outline(const std::string& pdf, const std::vector<Bookmark>& bookmarks);

}  // namespace stepwire::render
