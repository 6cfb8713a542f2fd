#pragma once

#include <string>
#include <vector>

namespace stepwire::mat {

/// Returns the variable names of columns in our MATLAB files. Invalid characters become '_'. The names are
/// unique, and none is a keyword of MATLAB, `names` or `units`.
std::vector<std::string> matlab_names(const std::vector<std::string>& columns);

}  // namespace stepwire::mat
