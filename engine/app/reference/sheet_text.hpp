#pragma once

#include <string>

#include "engine/app/reference/block_reference.hpp"

namespace stepwire::reference {

constexpr std::size_t page_width = 100;

/// Characters, not bytes: what continues one in UTF-8 has no width of its own.
std::size_t width(const std::string& text);
/// With blanks behind it, as wide as `to`.
std::string padded(const std::string& text, std::size_t to);
/// Breaks a text between words; lines after the first begin with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent);
/// Each line two blanks to the right.
std::string indented(const std::string& text);
/// No wider than `to`, between words.
std::string shortened(const std::string& text, std::size_t to);
/// A table with its title, for a terminal.
std::string table_text(const ReferenceTable& table);

/// The same for Markdown, with a heading of so many marks.
std::string table_markdown(const ReferenceTable& table, const std::string& marks);
/// A text that means no markup.
std::string escaped(const std::string& text);

}  // namespace stepwire::reference
