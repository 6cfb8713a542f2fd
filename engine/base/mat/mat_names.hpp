#pragma once

#include <string>
#include <vector>

namespace stepwire::mat {

/// Names of columns as a MATLAB file of ours has them: what MATLAB does not allow is replaced by '_', each is
/// there once, and none is a word of its language, `names` or `units`.
std::vector<std::string> matlab_names(const std::vector<std::string>& columns);

}  // namespace stepwire::mat
