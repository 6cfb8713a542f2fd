#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// Returns the files of a folder with an ending such as ".yaml", each behind a prefix: "parts/" + "rig.yaml".
/// The list is empty for an unreadable folder, and ends after some thousand files.
std::vector<std::string> files_of(const std::string& folder, const std::string& ending,
                                  const std::string& prefix);

/// Returns "did you mean 'cart.yaml'?" with the nearest name of a file of the same folder and ending.
Message near_file(const std::string& path);

}  // namespace stepwire::yaml
