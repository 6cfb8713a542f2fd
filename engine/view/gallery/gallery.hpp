#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::gallery {

/// Parameter whose value is not in the source.
struct Assumption {
  std::string name;
  std::string value;  ///< with its unit
  std::string doc;
};

/// Picture as SVG, in the folder of its entry.
struct GalleryPicture {
  std::string file;
  std::string title, caption;
  std::string alt;                   ///< Description in words.
  double width = 0.0, height = 0.0;  ///< Size at which it was drawn [px].
  bool own = false;                  ///< True if the source has no such picture.
  bool dark = false;                 ///< True if it is legible on dark pages.
  bool dense = false;                ///< True if it is too small for a card, which then has a part of it.
};

/// File for download, in the folder of its entry or of another one that has the same file.
struct GalleryDownload {
  std::string file;
  std::uintmax_t bytes = 0;
  std::string folder{};  ///< of the entry that has the file; empty: of the entry itself
  std::string label{};   ///< of the entry that has the file
};

/// File with pictures of several entries, a page each, and the first page of this entry.
struct GalleryPrint {
  std::string file;  ///< Path in the gallery; empty without a file.
  std::size_t page = 1;
};

/// Diagram file, and the path of its copy in the gallery: "diagrams/parts/hand.yaml".
struct GallerySource {
  std::string path;
  std::string text;
};

/// Page of one diagram file.
struct GalleryEntry {
  std::string folder;                ///< Folder of its page, pictures and data in the gallery.
  std::string label;                 ///< Label "Figure 15".
  std::optional<int> figure, table;  ///< Numbers in the source, by which entries are sorted.
  std::string section;  ///< Section in the source, "2.5.1"; the part before the first dot is the chapter.
  std::string title;
  std::string caption;
  std::string source_caption;           ///< Caption of the figure in the source.
  std::string source_says;              ///< Quotation from the text of the source on the figure.
  std::vector<std::string> departures;  ///< Departures from the source, a sentence each.
  std::vector<GalleryPicture> pictures;
  std::vector<claim::Verdict> verdicts;
  std::vector<Assumption> assumptions;
  std::vector<GallerySource> sources;  ///< Its diagram file, then its parts.
  std::vector<GalleryDownload> downloads;
  GalleryPrint print;
  std::string note;   ///< Note on the downloads.
  std::string error;  ///< Reason why it could not be run; empty without one.
};

/// Summary of the results for a chapter of the source.
struct ChapterSummary {
  std::string chapter;  ///< "4"
  std::string title;
  std::vector<std::string> sentences;
};

struct Gallery {
  std::string title;
  std::string introduction;
  std::vector<GalleryEntry> entries;
  std::vector<ChapterSummary> summaries{};  ///< each is on the page if there is an entry of its chapter
};

/// Returns the chapter: the part of its section before the first dot.
std::string chapter_of(const GalleryEntry& entry);

/// Returns all texts of the gallery by their path. These are a front page, a page for each entry, copies of
/// the diagram files and a page for each of them. They refer to nothing outside.
std::map<std::string, std::string> gallery_files(const Gallery& gallery);

/// Returns "229 of 239 claims hold, 10 known not to hold, 108 invariants held throughout."
std::string gallery_verdict(const std::vector<GalleryEntry>& entries);

}  // namespace stepwire::gallery
