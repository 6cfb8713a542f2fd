#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::gallery {

/// A parameter that the source does not give.
struct Assumption {
  std::string name;
  std::string value;  ///< with its unit
  std::string doc;
};

/// A picture as SVG, in the folder of its entry.
struct GalleryPicture {
  std::string file;
  std::string title, caption;
  std::string alt;                   ///< what it shows, in words
  double width = 0.0, height = 0.0;  ///< at which it was drawn [px]
  bool own = false;                  ///< the source has no such picture
  bool dark = false;                 ///< it suits dark pages
  bool dense = false;                ///< too small to be read on a card, which shows a part of it
};

/// A file that a reader may take along, in the folder of its entry or of another one that has the same file.
struct GalleryDownload {
  std::string file;
  std::uintmax_t bytes = 0;
  std::string folder{};  ///< of the entry that keeps the file; empty: of the entry itself
  std::string label{};   ///< of the entry that keeps the file
};

/// A file with pictures of several entries, a page each, and which page is the first of this entry.
struct GalleryPrint {
  std::string file;  ///< in the gallery; empty where there is none
  std::size_t page = 1;
};

/// A diagram file, and where its copy lies in the gallery: "diagrams/parts/hand.yaml".
struct GallerySource {
  std::string path;
  std::string text;
};

/// What is shown of one diagram file, on a page of its own.
struct GalleryEntry {
  std::string folder;                ///< of its page, pictures and data, in the gallery
  std::string label;                 ///< "Figure 15"
  std::optional<int> figure, table;  ///< numbers in the source, by which entries are ordered
  std::string section;  ///< of the source: "2.5.1"; its chapter is what stands before the first dot
  std::string title;
  std::string caption;
  std::string source_caption;           ///< of the figure, as the source prints it
  std::string source_says;              ///< what its text says of the figure
  std::vector<std::string> departures;  ///< what is done otherwise than in the source, a sentence each
  std::vector<GalleryPicture> pictures;
  std::vector<claim::Verdict> verdicts;
  std::vector<Assumption> assumptions;
  std::vector<GallerySource> sources;  ///< its diagram file, then the parts that it uses
  std::vector<GalleryDownload> downloads;
  GalleryPrint print;
  std::string note;   ///< what a reader should know of the downloads
  std::string error;  ///< why it could not be run; empty where it could
};

/// What came of a chapter of the source.
struct ChapterSummary {
  std::string chapter;  ///< "4"
  std::string title;
  std::vector<std::string> sentences;
};

struct Gallery {
  std::string title;
  std::string introduction;
  std::vector<GalleryEntry> entries;
  std::vector<ChapterSummary> summaries{};  ///< shown where an entry is of their chapter
};

/// The chapter of the source: what stands before the first dot of its section.
std::string chapter_of(const GalleryEntry& entry);

/// All texts of the gallery by their place in its folder: a front page, a page for each entry, copies of the
/// diagram files and a page for each of them. They need nothing from elsewhere.
std::map<std::string, std::string> gallery_files(const Gallery& gallery);

/// "229 of 239 claims hold, 10 known not to hold, 108 invariants held throughout."
std::string gallery_verdict(const std::vector<GalleryEntry>& entries);

}  // namespace stepwire::gallery
