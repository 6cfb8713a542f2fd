#pragma once

#include <string>

#include "engine/app/reference/block_reference.hpp"

namespace stepwire::reference {

constexpr std::size_t page_width = 100;

/// Returns the count of UTF-8 characters, as the width on the terminal.
std::size_t width(const std::string& text);
/// Pads a text with blanks to the width `to`.
std::string padded(const std::string& text, std::size_t to);
/// Wraps a text between words. Lines after the first are indented by `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent);
/// Indents each line by two blanks.
std::string indented(const std::string& text);
/// Shortens a text between words to the width `to`.
std::string shortened(const std::string& text, std::size_t to);
/// Formats a table with its title for the terminal.
std::string table_text(const ReferenceTable& table);

/// Formats a table as Markdown. `marks` are the '#' of the parent heading.
std::string table_markdown(const ReferenceTable& table, const std::string& marks);
/// Escapes Markdown markup.
std::string escaped(const std::string& text);

}  // namespace stepwire::reference
