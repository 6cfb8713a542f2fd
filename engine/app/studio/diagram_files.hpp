#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/app/language/open_texts.hpp"
#include "engine/app/studio/edited_texts.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::studio {

/// File that a page may open.
struct ListedFile {
  int number = 0;
  std::string name;  ///< path relative to the folder of FILE
  bool writable = false;
  bool is_part = false;  ///< true for a part of FILE
};

/// Numbered list of the files of a studio: its diagram (FILE), the parts of it, and the diagrams in its
/// folder. Not thread-safe.
class DiagramFiles {
 public:
  /// Throws EnvironmentError if the file does not exist.
  DiagramFiles(const std::string& file, DraftStore store = DraftStore());

  /// Returns the file access of language servers, which is limited to the folders. It is thread-safe and must
  /// not outlive this object.
  language::FileAccess access() const;
  EditedTexts& texts() { return texts_; }
  const Beneath& beneath() const { return beneath_; }
  /// Reads the folder again and returns all files. Numbers never change: 0 is FILE.
  std::vector<ListedFile> list();
  /// Returns the path of a file; throws Fault for a number that list() has not given.
  const std::string& path(int number) const;
  /// Returns the name that list() has for a path; a relative path is returned unchanged.
  std::string name(const std::string& path) const;
  /// Returns the number of a path; a new path gets the next one.
  int number(const std::string& path);

  /// Returns the edited documents of a diagram and of all its parts. Throws yaml::Error for one that is no
  /// YAML or names files outside the folders.
  std::vector<yaml::Document> documents(const std::string& path);

 private:
  void trust(const std::string& file);
  /// Throws yaml::Error if a document names files outside the folders.
  void require_inside(const yaml::Document& document) const;
  std::string text(const std::string& path);

  std::vector<std::string> paths_;
  std::map<std::string, int> numbers_;
  std::set<std::string> trusted_;
  Beneath beneath_;
  EditedTexts texts_;
};

}  // namespace stepwire::studio
