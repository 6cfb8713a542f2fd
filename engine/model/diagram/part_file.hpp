#pragma once

#include <string>

namespace stepwire::diagram {

/// The file that a diagram names by `diagram:`. The first of these that exists: the path beside the file that
/// names it; for "stepwire/oscillator" the part of that name that comes with the program; the path in each
/// folder of $STEPWIRE_PARTS, which ':' separates. Where none exists, the one beside.
std::string part_file(const std::string& user, const std::string& path);

/// The places other than beside the file where a part was looked for, as the end of a message.
std::string other_part_places(const std::string& path);

}  // namespace stepwire::diagram
