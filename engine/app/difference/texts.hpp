#pragma once

#include <map>
#include <memory>
#include <string>

#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/uses.hpp"

namespace stepwire::difference {

/// Text of a diagram file with its tree.
struct DiagramText {
  std::string text;
  yaml::Document document;
};

/// Texts of one side of a comparison: files, or texts that are given in their place.
class Texts {
 public:
  /// Uses a text in place of the file of this path, which may be missing.
  void give(const std::string& path, std::string text);
  /// Reads a file once. Throws yaml::Error for a missing file and for invalid YAML.
  const DiagramText& read(const std::string& path);
  /// Returns nullptr where read() would throw.
  const DiagramText* find(const std::string& path);
  /// Returns these texts with another text of one file.
  Texts with(const std::string& path, std::string text) const;
  /// Returns the path of a part that a file names; empty for one of files that are not fetched.
  std::string part_path(const std::string& user, const std::string& part);

 private:
  std::map<std::string, std::shared_ptr<const DiagramText>> texts_;
  diagram::FetchedTrees fetched_;
};

}  // namespace stepwire::difference
