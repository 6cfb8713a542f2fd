#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::gallery {

/// Table of a report: a row of names, and rows of cells.
struct ReportTable {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::string note{};  ///< Sentence above the table.
};

/// Picture of a report, as SVG text.
struct ReportPicture {
  std::string title, caption, alt;
  std::string svg;
};

/// Report of one diagram file. The entry has its texts, verdicts and sources.
struct Report {
  GalleryEntry entry;
  std::vector<ReportPicture> drawings, figures;
  std::vector<ReportTable> tables;
};

/// Returns one page with all reports, which refers to no other file.
std::string report_page(const std::string& title, const std::vector<Report>& reports);

}  // namespace stepwire::gallery
