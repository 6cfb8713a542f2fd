#pragma once

#include "engine/base/yaml/place.hpp"

namespace stepwire::diagram {

/// Location in a file of a diagram: `scope` identifies the file and its user.
struct Origin {
  int scope = 0;
  yaml::Mark mark;
};

}  // namespace stepwire::diagram
