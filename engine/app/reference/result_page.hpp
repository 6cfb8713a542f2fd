#pragma once

#include <string>

#include "engine/base/result/result_type.hpp"

namespace stepwire::reference {

/// Returns the fields of a result and of the records that it contains for the terminal: type, unit, meaning.
std::string result_page(const result::RecordType& type);
/// Returns the same as Markdown, with a heading of this level.
std::string result_markdown(const result::RecordType& type, int level = 1);

}  // namespace stepwire::reference
