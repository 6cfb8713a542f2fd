#pragma once

#include <string>

#include "engine/app/reference/sections.hpp"

namespace stepwire::reference {

/// The keys of a section for a terminal: value, unit, range, default, meaning, and an example.
std::string format_page(const Section& section);
/// The same as Markdown, under a heading of this level.
std::string format_markdown(const Section& section, int level = 1);

/// All sections with a line on each.
std::string format_list();
/// All sections as one page of Markdown.
std::string formats_markdown();

}  // namespace stepwire::reference
