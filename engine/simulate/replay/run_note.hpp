#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::replay {

/// What run.json says of a run.
struct RunNote {
  std::vector<std::string> swept{};  ///< parameters of a sweep, in the order of their columns; empty for none
  std::size_t runs = 1;
  std::string keep{};                   ///< what a sweep keeps of each run
  std::vector<std::size_t> recorded{};  ///< runs, from 0, whose rows stay beside numbers of all
  yaml::Node document{};                ///< all of it
};

/// Throws Error where the file does not say what every run says.
RunNote read_run_note(const std::string& file);

}  // namespace stepwire::replay
