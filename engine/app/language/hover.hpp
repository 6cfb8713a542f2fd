#pragma once

#include <optional>
#include <string>

#include "engine/app/language/analysis.hpp"

namespace stepwire::language {

/// Explanation of a place: Markdown, and the range that it explains.
struct Hover {
  std::string markdown;
  TextRange range;
};

/// Returns the reference of a block or key, the unit of a signal, or unit and value of a parameter;
/// std::nullopt for other places.
std::optional<Hover> hover(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                           std::size_t offset);

}  // namespace stepwire::language
