#pragma once

#include <filesystem>
#include <string>

#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

/// Refuses to overwrite an input of the call (the diagram, its parts, its data) by the output file `out`. An
/// empty `out` is no file. Throws Error.
template <class Paths>
void keep_inputs(const std::string& out, const Paths& read) {
  std::error_code none;
  for (const std::string& file : read)
    if (!out.empty() && std::filesystem::equivalent(file, out, none))
      throw yaml::Error(yaml::Fault{
          {file, {}}, "", "would be written over by this call, which reads it; give another name", {}});
}

}  // namespace stepwire::cli
