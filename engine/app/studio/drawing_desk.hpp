#pragma once

#include <map>
#include <string>

#include "engine/app/language/language_service.hpp"
#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// Link from the drawing of a diagram to its text. It returns the range of each shape, and the text changes
/// of an edit in the drawing. Not thread-safe.
class DrawingDesk {
 public:
  explicit DrawingDesk(Desk& desk) : desk_(desk), service_(desk.registry, desk.files.access()) {}

  /// Returns {"cart": {file, from, to}} for all blocks and ports of a file, in UTF-16 units.
  json::Json ranges(const std::string& path);
  /// Returns {changes: [{file, from, to, text}], name, faults}. Throws Fault, language::EditRefused.
  json::Json splice(const Arguments& arguments);
  /// Returns {inputs: [{node, input}]}, the inputs to which a signal may be connected.
  json::Json fits(const Arguments& arguments);

 private:
  /// Returns the path of the file that a call names; throws Fault if its version is not the current one.
  std::string path(const Arguments& arguments);
  /// Passes all changed texts to the language service.
  void follow();
  json::Json range(const language::Utf16Range& range);

  Desk& desk_;
  language::LanguageService service_;
  std::map<std::string, int> versions_;  ///< versions of the texts in the service
};

}  // namespace stepwire::studio
