#pragma once

#include "engine/base/yaml/place.hpp"

namespace stepwire::diagram {

/// A place in one of the files of a diagram: `scope` says in which file, and who uses it.
struct Origin {
  int scope = 0;
  yaml::Mark mark;
};

}  // namespace stepwire::diagram
