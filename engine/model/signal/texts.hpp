#pragma once

#include <string>
#include <vector>

namespace stepwire {

#ifdef STEPWIRE_LONGEST_LIST
/// Texts that a block is given and reads before a run only: there are none in a generated program, which only
/// steps.
class Texts {};
#else
/// Texts that a block is given and reads before a run only.
using Texts = std::vector<std::string>;
#endif

}  // namespace stepwire
