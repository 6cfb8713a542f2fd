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

/// A file that a page may open.
struct ListedFile {
  int number = 0;
  std::string name;  ///< as it is seen from the folder of FILE
  bool writable = false;
  bool is_part = false;  ///< of FILE
};

/// The diagram that the studio was started with, its parts, and the diagrams beside it, by number. One thread
/// at a time.
class DiagramFiles {
 public:
  /// Throws EnvironmentError where there is no such file.
  DiagramFiles(const std::string& file, DraftStore store = DraftStore());

  /// How language servers reach files: beneath the folders alone. From any thread, as long as this is there.
  language::FileAccess access() const;
  EditedTexts& texts() { return texts_; }
  const Beneath& beneath() const { return beneath_; }
  /// Looks again at what there is. Numbers never change: 0 is FILE.
  std::vector<ListedFile> list();
  /// Throws Fault for a number that list() has not given.
  const std::string& path(int number) const;
  /// How list() calls a file; a path that is none of a file stays what it is.
  std::string name(const std::string& path) const;
  /// Of a path that is known, or is known from now on.
  int number(const std::string& path);

  /// The documents of a diagram and of all its parts, as they are edited. Throws yaml::Error for what is no
  /// YAML, and for parts that do not lie beneath the folders.
  std::vector<yaml::Document> documents(const std::string& path);

 private:
  void trust(const std::string& file);
  /// Throws yaml::Error where a document names files that lie elsewhere.
  void require_inside(const yaml::Document& document) const;
  std::string text(const std::string& path);

  std::vector<std::string> paths_;
  std::map<std::string, int> numbers_;
  std::set<std::string> trusted_;
  Beneath beneath_;
  EditedTexts texts_;
};

}  // namespace stepwire::studio
