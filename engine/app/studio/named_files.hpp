#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::studio {

/// Something on the disk that a value of a diagram may name.
struct NamedFile {
  std::string path;  ///< absolute where the diagram's is, without "." and ".."
  std::string word;  ///< as the diagram names it
  yaml::Mark mark;
  bool is_diagram = false;  ///< a part, by its key, or a diagram by its ending
  bool is_plain = true;     ///< false where ".." behind a link leads elsewhere than the path says
};

/// All values of a diagram that name something which is there, from its folder, from the root, or in the data
/// folder; whatever the value is for. No text can name a file in any other way.
std::vector<NamedFile> named_files(const yaml::Document& document);

/// $STEPWIRE_DATA without links and ".."; empty where there is none.
std::string data_folder();

}  // namespace stepwire::studio
