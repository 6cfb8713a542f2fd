#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::replay {

/// Content of run.json.
struct RunNote {
  std::vector<std::string> swept{};  ///< swept parameters in the order of their columns
  std::size_t runs = 1;
  std::string keep{};                   ///< value of the sweep's `keep`
  std::vector<std::size_t> recorded{};  ///< indices of runs whose rows are kept beside numbers of all runs
  yaml::Node document{};                ///< the whole file
};

/// Throws Error if the file lacks an entry that every run writes.
RunNote read_run_note(const std::string& file);

}  // namespace stepwire::replay
