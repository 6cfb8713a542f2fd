#pragma once

#include <string>

#include "engine/app/cli/call_words.hpp"

namespace stepwire::cli {

/// The manual page stepwire(1) as roff: all verbs with their options, made of what they declare.
std::string man_page(const VerbWords& program, const std::vector<VerbWords>& verbs);

}  // namespace stepwire::cli
