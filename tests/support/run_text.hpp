#pragma once

#include <string>

#include "engine/base/table/table.hpp"

namespace stepwire {

/// Runs a diagram given as text, with every block of the library, and returns its first recording. The head
/// keys "stepwire: 1" and "title" may be left out; they are added.
table::Table run_text(const std::string& yaml);

/// A recorded column; fails the test if it is not there.
const std::vector<double>& column(const table::Table& table, const std::string& name);

/// The message with which loading or running the text is refused; empty if it is not.
std::string error_of(const std::string& yaml);

}  // namespace stepwire
