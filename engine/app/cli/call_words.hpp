#pragma once

#include <vector>

#include "engine/app/reference/verb_words.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

using reference::OptionWords;
using reference::VerbWords;

/// Returns the options of the program before the verb.
VerbWords program_words(const CLI::App& program);

/// Returns all verbs of the program in the order of declaration.
std::vector<VerbWords> verb_words(const CLI::App& program);

}  // namespace stepwire::cli
