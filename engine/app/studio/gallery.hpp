#pragma once

#include <string>
#include <vector>

namespace stepwire::studio {

/// A diagram that comes with the program.
struct GalleryEntry {
  std::string path;  ///< on this machine
  std::string name;  ///< "72-figure-of-eight"
  std::string title;
  std::string caption;  ///< on one line
  std::string group;    ///< the folder that it lies in: "examples", "thesis"
};

/// All of them, in the order of their names; none where the program came without.
std::vector<GalleryEntry> gallery();

/// A file that a copy consists of.
struct CopiedFile {
  std::string path, text;
};

/// A diagram as it is written under a path, with all files that it names: these go into a folder beside it,
/// "NAME-parts", and the copies name each other there. Throws yaml::Error, EnvironmentError.
std::vector<CopiedFile> copies_of(const std::string& diagram, const std::string& file);

}  // namespace stepwire::studio
