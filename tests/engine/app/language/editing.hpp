#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/app/language/language_service.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::language {

/// A language service with the files of a folder; positions are given by the words at them.
class Editing {
 public:
  Editing();

  /// Opens a text as a file of the folder, without writing it there.
  void open(const std::string& name, const std::string& text);
  /// Writes a file of the folder that is not open.
  void write(const std::string& name, const std::string& text);
  std::string path(const std::string& name) const { return folder_.path(name); }
  const std::string& text(const std::string& name) const { return texts_.at(name); }
  LanguageService& service() { return service_; }

  /// All that is wrong in a file, in the order of the text.
  std::vector<TextDiagnostic> diagnostics(const std::string& name);
  /// "WORDS: MESSAGE" for each, WORDS being what its range holds.
  std::vector<std::string> wrong(const std::string& name);
  /// The place `behind` bytes behind the start of a word.
  EditorPosition at(const std::string& name, std::string_view word, std::size_t behind = 0) const;
  /// Labels of what may be written there.
  std::vector<std::string> labels(const std::string& name, std::string_view word, std::size_t behind);
  std::string hover(const std::string& name, std::string_view word, std::size_t behind = 0);
  /// The text of a file after a change of a name at a place.
  std::map<std::string, std::string> renamed(const std::string& name, std::string_view word,
                                             std::size_t behind, const std::string& to);

  /// The texts of files after an edit of one, whose places count UTF-16.
  std::map<std::string, std::string> edited(const std::string& name, const Edit& edit);

 private:
  Scratch folder_;
  LanguageService service_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::vector<TextDiagnostic>> shown_;
};

/// The piece of a text that a range holds.
std::string in_range(const std::string& text, const EditorRange& range);

/// The text above the blocks of a small diagram.
inline const std::string file_head = "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 s\nsolver: rk4\n";

}  // namespace stepwire::language
