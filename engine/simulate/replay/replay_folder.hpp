#pragma once

#include <set>
#include <string>

#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Writes the files that verify() needs into the folder of a run. These are the flattened diagram, and under
/// inputs/ copies of all data files that it reads. A sweep has a diagram for each structure, and the table of
/// the values that each run sets in it. Throws EnvironmentError.
void write_replay(const std::string& folder, const run::Job& job);
/// Writes the same for one plan, such as that of a real-time loop.
void write_replay(const std::string& folder, const plan::Plan& plan);

/// Returns the files that a job reads: diagrams, parts and data.
std::set<std::string> files_read(const run::Job& job);
std::set<std::string> files_read(const plan::Plan& plan);

/// Name of the flattened diagram in such a folder.
inline constexpr const char* flattened_name = "diagram.yaml";
/// Limits for reading it. It has the size of all its parts together and exceeds those of files that people
/// write.
inline constexpr yaml::DocumentLimits wide_limits{
    .bytes = std::size_t{512} << 20, .depth = 64, .nodes = 64'000'000};
/// Table of a sweep, with a row for each run. It has the name of its diagram if there are several, and the
/// values of blocks that it sets, in the format of diagram files.
inline constexpr const char* sweep_name = "sweep.csv";
/// First column with several diagrams: their names in the folder, "diagrams/0001.yaml", ...
inline constexpr const char* diagram_column = "diagram";

}  // namespace stepwire::replay
