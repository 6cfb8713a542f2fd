#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/model/diagram/bindings.hpp"

namespace stepwire::diagram {

/// What a data file is called in a flattened diagram, by the path at which it is found.
using FileName = std::function<std::string(const std::string& path)>;

/// The path from the root of the file system, so that it is found from anywhere on this machine.
std::string absolute_path(const std::string& path);

/// A diagram as the text of one file that does the same, to the last bit: parts opened, parameters and
/// expressions replaced by their SI numbers, wires and recorded signals by the full names of blocks.
/// Names and units of recorded columns stay. What is not of the run is left out: sweep, figure, claims.
std::string flattened_text(const Diagram& diagram, const FileName& file_name = absolute_path);

/// The value of a block as the flattened diagram has it; nothing where only a default can be.
std::optional<yaml::Node> flattened_value(const Diagram& diagram, const Target& target,
                                          const FileName& file_name);

/// Hash of all that decides what a diagram computes, the contents of its data files included; 16 hexadecimal
/// digits (FNV-1a, 64 bits). The same for two files that differ only in layout, units, names of files, or
/// parts opened by hand. Throws EnvironmentError where a data file cannot be read.
std::string diagram_hash(const Diagram& diagram);

}  // namespace stepwire::diagram
