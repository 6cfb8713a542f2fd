#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::studio {

/// Content of a file, with the mode that its replacement gets.
struct FileContent {
  std::string text;
  mode_t mode = 0;
};

/// Sandbox of folders: a page may open files only inside them. Neither ".." nor symbolic links lead out of
/// it, also not links that are created during a call.
class Beneath {
 public:
  /// Adds a folder; links in its own path are followed. Does nothing if it cannot be opened.
  void add(const std::string& folder);

  /// The functions below take absolute paths without "." and "..". They throw Fault if the file is outside
  /// the folders, is no regular file, or the system refuses access.
  FileContent read(const std::string& path) const;
  bool is_writable(const std::string& path) const;
  /// Replaces a file atomically: writes a sibling with the same mode, syncs it and renames it.
  void replace(const std::string& path, std::string_view text) const;
  /// True if a path leads to a file or folder inside the folders.
  bool holds(const std::string& path) const;
  /// Creates a file, and its folder if that is missing; throws Fault if the file exists.
  void create(const std::string& path, std::string_view text) const;

 private:
  struct Folder {
    std::string path;  ///< with "/" at its end
    io::Descriptor open;
  };
  io::Descriptor open(const std::string& path, int flags) const;

  std::vector<Folder> folders_;
};

}  // namespace stepwire::studio
