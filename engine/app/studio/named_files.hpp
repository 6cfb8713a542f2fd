#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::studio {

/// File that a value of a diagram names.
struct NamedFile {
  std::string path;  ///< normalised; absolute if the path of the diagram is
  std::string word;  ///< name as written in the diagram
  yaml::Mark mark;
  bool is_diagram = false;  ///< true for a part (by its key) and for any .yaml or .yml file
  bool is_plain = true;     ///< false if ".." behind a link leads to another file than `path`
};

/// Returns all values of a diagram that name an existing file, whatever their key. Names are absolute or
/// relative to the folder of the diagram or the data folder; a diagram cannot name files in another way.
std::vector<NamedFile> named_files(const yaml::Document& document);

/// Returns $STEPWIRE_DATA without links and ".."; "" if it is not set.
std::string data_folder();

}  // namespace stepwire::studio
