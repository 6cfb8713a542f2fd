#pragma once

#include <string>

/// Whether a text is a diagram of its own, not a piece of one.
bool is_diagram(const std::string& yaml);

/// Whether a diagram is only used in others: it has ports and no end.
bool is_part(const std::string& yaml);

/// A diagram with the sections of a piece: those that list things by name get longer, others are replaced.
std::string with_sections(const std::string& diagram, const std::string& piece);

/// Whether a file contains the lines of a piece in one go, indented or not.
bool stands_in(const std::string& piece, const std::string& file);
