#pragma once

#include <string>

#include "engine/app/cli/call_words.hpp"

namespace stepwire::cli {

/// Returns the manual page stepwire(1) as roff, generated from the declarations of the verbs.
std::string man_page(const VerbWords& program, const std::vector<VerbWords>& verbs);

}  // namespace stepwire::cli
