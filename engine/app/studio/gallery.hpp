#pragma once

#include <string>
#include <vector>

namespace stepwire::studio {

/// Diagram that is installed with the program.
struct GalleryEntry {
  std::string path;  ///< on this machine
  std::string name;  ///< "72-figure-of-eight"
  std::string title;
  std::string caption;  ///< a single line
  std::string group;    ///< its folder: "examples", "thesis"
};

/// Returns all entries, sorted by group and name; an empty list if no diagrams are installed.
std::vector<GalleryEntry> gallery();

/// File of a copy.
struct CopiedFile {
  std::string path, text;
};

/// Returns the copies of a diagram and of all files that it names, for writing the diagram to `file`. The
/// named files go into the folder "NAME-parts" beside it, and the copies refer to each other there. Throws
/// yaml::Error, EnvironmentError.
std::vector<CopiedFile> copies_of(const std::string& diagram, const std::string& file);

}  // namespace stepwire::studio
