#pragma once

#include <set>
#include <string>
#include <string_view>

namespace stepwire::codegen {

/// A text of a diagram as part of a comment of C++, wherever it stands there: on one line, and without what
/// ends a comment or takes the next line into it.
std::string cpp_comment(std::string_view text);

/// A name of a diagram or of its file as one of C++: "rig.carriage" is rig_carriage. A program puts another
/// word behind it, so that no word of the language or name of a library stands alone.
std::string cpp_identifier(std::string_view name);

/// The same as a member of a struct, "rig_carriage_", with a number behind it where that is taken.
std::string free_member(std::string_view name, std::set<std::string>& taken);

/// A text as a string literal of C++ that has its very bytes, whatever they are.
std::string cpp_string(std::string_view text);

}  // namespace stepwire::codegen
