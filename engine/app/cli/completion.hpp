#pragma once

#include <string>

#include "engine/app/cli/call_words.hpp"

namespace stepwire::cli {

/// Return shell scripts that complete verbs, options, their choices, and files. The scripts are generated
/// from the declarations of the verbs and run no other program.
std::string bash_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);
std::string zsh_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);
std::string fish_completion(const VerbWords& program, const std::vector<VerbWords>& verbs);

}  // namespace stepwire::cli
