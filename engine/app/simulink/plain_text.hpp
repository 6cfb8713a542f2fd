#pragma once

#include <string>
#include <vector>

namespace stepwire::simulink {

/// Returns a text on one line: breaks and tabs become blanks, ends are trimmed.
std::string on_one_line(const std::string& text);
/// Returns the text of an annotation without tags of HTML, on one line.
std::string without_markup(const std::string& text);
/// Returns the parts between separators, trimmed, without empty ones at the end.
std::vector<std::string> parts_of(const std::string& text, char separator);
/// Returns a name of letters, digits and '_', made of any text: "Transfer_Fcn" of "Transfer Fcn".
std::string valid_name(const std::string& text);
/// Returns the same text in lower case.
std::string lower_case(std::string text);

}  // namespace stepwire::simulink
