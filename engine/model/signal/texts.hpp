#pragma once

#include <string>
#include <vector>

namespace stepwire {

#ifdef STEPWIRE_LONGEST_LIST
/// List of text parameters. Empty in generated programs, which only step.
class Texts {};
#else
/// List of text parameters, read only before a run.
using Texts = std::vector<std::string>;
#endif

}  // namespace stepwire
