#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/model/diagram/bindings.hpp"

namespace stepwire::diagram {

/// Function that returns the name of a data file in a flattened diagram from its path.
using FileName = std::function<std::string(const std::string& path)>;

/// Returns the absolute path, which is valid everywhere on this machine.
std::string absolute_path(const std::string& path);

/// Returns a diagram as the text of one file with the same results to the last bit. Parts are opened,
/// parameters and expressions are replaced by their SI numbers. Wires and recorded signals use the full names
/// of blocks. Names and units of recorded columns stay. Sections that do not affect a run are left out:
/// sweep, figure, claims.
std::string flattened_text(const Diagram& diagram, const FileName& file_name = absolute_path);

/// Returns the value of a block in the flattened diagram; std::nullopt where the file could only leave the
/// default.
std::optional<yaml::Node> flattened_value(const Diagram& diagram, const Target& target,
                                          const FileName& file_name);

/// Returns a hash of all that determines the results of a diagram, including the contents of its data files.
/// It has 16 hexadecimal digits (FNV-1a, 64 bits). Files that differ only in layout, units, names of files,
/// or parts opened by hand have the same hash. Throws EnvironmentError for an unreadable data file.
std::string diagram_hash(const Diagram& diagram);

}  // namespace stepwire::diagram
