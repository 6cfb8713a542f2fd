#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::diagram {

/// Returns the file that a diagram names by `diagram:`. Candidates are the path beside the using file, then
/// for "stepwire/oscillator" the part of that name that comes with the program. Last is the path in each
/// folder of $STEPWIRE_PARTS, separated by ':'. The first existing file is returned, else the path beside the
/// using file.
std::string part_file(const std::string& user, const std::string& path);

/// Returns the file of a part that a document names. A path that begins with a name of its section `uses` is
/// a file of the cache of fetched parts, which may be missing.
std::string part_file(const yaml::Document& user, const std::string& path);

/// Returns the folders of STEPWIRE_PARTS in their order.
std::vector<std::string> part_folders();

/// Returns "did you mean 'stepwire/oscillator'?" with the nearest name among the parts beside the using file,
/// those that come with the program, and those in the folders of STEPWIRE_PARTS.
yaml::Message near_part(const std::string& user, const std::string& path);
/// Returns the same for a path that may begin with a name of the section `uses`.
yaml::Message near_part(const yaml::Document& user, const std::string& path);

/// Returns the other searched locations, as the end of a message.
std::string other_part_places(const std::string& path);

}  // namespace stepwire::diagram
