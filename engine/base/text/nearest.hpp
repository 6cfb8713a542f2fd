#pragma once

#include <string>
#include <vector>

namespace stepwire::text {

/// Returns the name that is nearest to a misspelt word; nullptr if none is near. A name is near if it differs
/// by a third of the letters at most, or if the word is its beginning, its last part or its initials.
const std::string* nearest(const std::string& word, const std::vector<std::string>& names);

/// Returns "; did you mean 'tau'?" with the nearest name, as the end of a message; empty if none is near.
std::string or_nearest(const std::string& word, const std::vector<std::string>& names);

}  // namespace stepwire::text
