#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// These headers and all of ours that they include, from the root of the sources, sorted.
std::vector<std::string> with_included(const std::vector<std::string>& headers);

/// The text of one of our headers. Throws SurroundingsError where the sources are not there.
std::string header_text(const std::string& header);

/// That of what expressions call.
inline constexpr const char* language_header = "engine/base/expression/language.hpp";

/// Refuses what only the program itself can run: throws Error with the lines of all such blocks.
void require_headers(const Plan& plan);

/// The headers that the code of a plan needs, from the root of the sources, sorted.
std::vector<std::string> headers_of(const Plan& plan);

}  // namespace stepwire
