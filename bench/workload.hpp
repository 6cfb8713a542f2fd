#pragma once

#include <string>

namespace stepwire {

/// W1: the path of its diagram file.
std::string w1_file();

/// W2, a graph of `blocks` blocks (and 2 for the source), as the text of a diagram file that records 8 of its
/// signals.
std::string w2_text(int blocks, int steps);

}  // namespace stepwire
