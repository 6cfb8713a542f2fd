#pragma once

#include <map>
#include <string>

#include "engine/app/language/language_service.hpp"
#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// What the drawing of a diagram needs to know of its text: where each shape stands, and which changes of the
/// text an edit of the drawing is. One thread at a time.
class DrawingDesk {
 public:
  explicit DrawingDesk(Desk& desk) : desk_(desk), service_(desk.registry, desk.files.access()) {}

  /// {"cart": {file, from, to}} of all blocks and ports of a file, in units of UTF-16.
  json::Json ranges(const std::string& path);
  /// {changes: [{file, from, to, text}], name, faults}. Throws Fault, language::EditRefused.
  json::Json splice(const Arguments& arguments);
  /// {inputs: [{node, input}]} to which a signal may be connected.
  json::Json fits(const Arguments& arguments);

 private:
  /// The path of the file that a call names, in the version that it means.
  std::string path(const Arguments& arguments);
  /// Has the service know all texts as they are edited.
  void follow();
  json::Json range(const language::Utf16Range& range);

  Desk& desk_;
  language::LanguageService service_;
  std::map<std::string, int> versions_;  ///< of the texts that the service has
};

}  // namespace stepwire::studio
