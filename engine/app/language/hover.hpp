#pragma once

#include <optional>
#include <string>

#include "engine/app/language/analysis.hpp"

namespace stepwire::language {

/// What is told of a place: Markdown, and the text that it is about.
struct Hover {
  std::string markdown;
  TextRange range;
};

/// The reference of a block or key, the unit of a signal, unit and value of a parameter.
std::optional<Hover> hover(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                           std::size_t offset);

}  // namespace stepwire::language
