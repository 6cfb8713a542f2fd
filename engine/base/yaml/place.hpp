#pragma once

#include <string>

namespace stepwire::yaml {

/// Line and column in a file, counted from 1; 0 means the file as a whole.
struct Mark {
  int line = 0;
  int column = 0;
};

/// Location in a file.
struct Place {
  std::string file;
  Mark mark;
};

}  // namespace stepwire::yaml
