#pragma once

#include <string>

namespace stepwire::diagram {

/// Returns a hint for the name of a Simulink block, as "use `record` and `figure`"; empty for other names.
/// Case, blanks and punctuation are ignored.
std::string answer_to_simulink(const std::string& name);

}  // namespace stepwire::diagram
