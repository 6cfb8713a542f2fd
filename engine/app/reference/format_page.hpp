#pragma once

#include <string>

#include "engine/app/reference/sections.hpp"

namespace stepwire::reference {

/// Returns the keys of a section for the terminal: value, unit, range, default, meaning, and an example.
std::string format_page(const Section& section);
/// Returns the same as Markdown, with a heading of this level.
std::string format_markdown(const Section& section, int level = 1);

/// Returns the list of all sections with a line on each.
std::string format_list();
/// Returns all sections as one Markdown page.
std::string formats_markdown();

}  // namespace stepwire::reference
