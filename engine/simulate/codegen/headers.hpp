#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// These headers and all of ours that they include, from the root of the sources, sorted.
std::vector<std::string> with_included(const std::vector<std::string>& headers);

/// The text of one of our headers. Throws SurroundingsError where the sources are not there.
std::string header_text(const std::string& header);

}  // namespace stepwire
