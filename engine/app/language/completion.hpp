#pragma once

#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/writing_place.hpp"

namespace stepwire::language {

/// One thing that may be written at a place.
struct Completion {
  enum class Kind { key, type, word, signal, parameter, unit, file };
  std::string label;
  Kind kind;
  std::string text;  ///< that is written in place of `range`
  TextRange range;
  std::string detail{};  ///< a few words beside the label
  std::string doc{};     ///< Markdown
  int rank = 0;          ///< the least come first: what is required, or whose unit fits
};

/// All that may be written at a place of a file, in the order of use: first what must be given, or what fits
/// by its unit. `analysis` is the last one of the file that has a draft.
std::vector<Completion> complete(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                 std::size_t offset);

}  // namespace stepwire::language
