#pragma once

#include <string>

namespace stepwire::diagram {

/// The file that a diagram names by `diagram:`. A path lies beside the file that names it or, where nothing
/// is there, in the first folder of $STEPWIRE_PARTS (separated by ':') that has it. "stepwire/oscillator" is
/// the part of that name among those that come with the program. A path that is nowhere stays the one beside.
std::string part_file(const std::string& user, const std::string& path);

/// The places other than beside the file where a part was looked for, as the end of a message.
std::string other_part_places(const std::string& path);

}  // namespace stepwire::diagram
