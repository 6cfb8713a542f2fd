#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::studio {

/// The content of a file with what it takes to replace it alike.
struct FileContent {
  std::string text;
  mode_t mode = 0;
};

/// Folders beneath which a page may open files. Nothing outside of them is reached: not by "..", not by a
/// link on the way, not by one that comes in between.
class Beneath {
 public:
  /// A folder that is trusted as it is now, also where links lead there. Nothing where it cannot be opened.
  void add(const std::string& folder);

  /// Absolute paths without "." and "..". Throw Fault where a file does not lie beneath a folder, is no plain
  /// file, or the system refuses it.
  FileContent read(const std::string& path) const;
  bool is_writable(const std::string& path) const;
  /// Writes beside the file, makes that safe, and gives it the name and the mode of the file.
  void replace(const std::string& path, std::string_view text) const;
  /// Does a path lead to something beneath the folders?
  bool holds(const std::string& path) const;
  /// A new file, in a folder that is made where there is none; throws Fault where there is one already.
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
