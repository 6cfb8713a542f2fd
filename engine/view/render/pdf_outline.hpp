#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::render {

/// An entry of the outline of a PDF file.
struct Bookmark {
  std::string title;     ///< UTF-8
  std::size_t page = 1;  ///< counted from 1
};

/// Returns the PDF file with an outline. The outline is an update at the end of the file, as the format has
/// it (PDF 1.7, 7.5.6). Only a file with a plain table of its objects is changed, as Cairo 1.16 writes;
/// another one, or one without a bookmark's page, is returned as it is.
std::string with_outline(const std::string& pdf, const std::vector<Bookmark>& bookmarks);

}  // namespace stepwire::render
