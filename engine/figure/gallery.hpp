#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/claim.hpp"

namespace stepwire {

/// A parameter that the source does not give.
struct Assumption {
  std::string name;
  std::string value;  ///< with its unit
  std::string doc;
};

/// One diagram file on the gallery page. Paths are relative to the page.
struct GalleryEntry {
  std::string label;                 ///< "Figure 15"
  std::optional<int> figure, table;  ///< numbers in the source, by which entries are ordered
  std::string section;  ///< of the source: "2.5.1"; its chapter is what stands before the first dot
  std::string title;
  std::string caption;
  std::vector<std::string> pictures;
  std::vector<Verdict> verdicts;
  std::vector<Assumption> assumptions;
  std::string diagram;  ///< link to the diagram file
  std::string folder;   ///< with what the run wrote
  std::string error;    ///< why it could not be run; empty where it could
};

struct Gallery {
  std::string title;
  std::string introduction;
  std::vector<GalleryEntry> entries;
};

/// A self-contained static HTML page: what is reproduced, what disagrees with the source and what is assumed,
/// and a card for each entry.
std::string gallery_page(const Gallery& gallery);

}  // namespace stepwire
