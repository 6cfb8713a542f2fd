#pragma once

#include <string>

#include "engine/app/cli/call_words.hpp"

namespace stepwire::cli {

/// Scripts by which a shell completes verbs, options, their choices, and files. They are made of what the
/// verbs declare and run no other program.
std::string bash_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);
std::string zsh_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);
std::string fish_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);

}  // namespace stepwire::cli
