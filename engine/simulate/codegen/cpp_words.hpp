#pragma once

#include <set>
#include <string>
#include <string_view>

namespace stepwire::codegen {

/// Returns a text of a diagram as a part of a C++ comment. It is on one line, without anything that ends the
/// comment or continues it on the next line.
std::string cpp_comment(std::string_view text);

/// Returns the C++ identifier of a name in a diagram or file: "rig.carriage" gives rig_carriage. Programs
/// append another word, so the result cannot be a keyword or a name of a library.
std::string cpp_identifier(std::string_view name);

/// Returns the same as a member of a struct, "rig_carriage_", with a number appended if that name is taken.
std::string free_member(std::string_view name, std::set<std::string>& taken);

/// Returns a C++ string literal with exactly the bytes of a text.
std::string cpp_string(std::string_view text);

}  // namespace stepwire::codegen
