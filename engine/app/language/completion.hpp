#pragma once

#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"

namespace stepwire::language {

/// Proposal for the text at the cursor.
struct Completion {
  enum class Kind { key, type, word, signal, parameter, unit, file };
  std::string label;
  Kind kind;
  std::string text;  ///< replacement of `range`
  TextRange range;
  std::string detail{};  ///< short note beside the label
  std::string doc{};     ///< explanation in Markdown
  int rank = 0;          ///< sort key: required keys and fitting units have the lowest
};

/// Returns the proposals at a position of a file: required keys or fitting units first. `analysis` is the
/// last one of the file that has a draft.
std::vector<Completion> complete(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                 std::size_t offset);

}  // namespace stepwire::language
