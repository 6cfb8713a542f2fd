#pragma once

#include <string>

namespace stepwire::diagram {

/// What there is here for a block of Simulink, as a sentence: "use `record` and `figure`"; empty for a name that
/// is none of Simulink's. Capitals, blanks and signs between words do not count.
std::string answer_to_simulink(const std::string& name);

}  // namespace stepwire::diagram
