#pragma once

#include <set>
#include <string>

#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Writes into the folder of a run what verify() needs: the flattened diagram, for a sweep one for each
/// structure and the table of what each run sets in it, and under inputs/ a copy of every data file that they
/// read. Throws EnvironmentError.
void write_replay(const std::string& folder, const run::Job& job);
/// The same for one plan, such as that of a real-time loop.
void write_replay(const std::string& folder, const plan::Plan& plan);

/// The files that a job reads: diagrams, parts and data.
std::set<std::string> files_read(const run::Job& job);
std::set<std::string> files_read(const plan::Plan& plan);

/// Name of the flattened diagram in such a folder.
inline constexpr const char* flattened_name = "diagram.yaml";
/// For reading it: it is as large as all of its parts together, beyond what a person writes.
inline constexpr yaml::DocumentLimits wide_limits{
    .bytes = std::size_t{512} << 20, .depth = 64, .nodes = 64'000'000};
/// Table of a sweep: a row for each run, with the diagram that it runs where there are several, and the
/// values of blocks that it sets in it, each as a file writes it.
inline constexpr const char* sweep_name = "sweep.csv";
/// Its first column where there are several diagrams: their names in the folder, "diagrams/0001.yaml", ...
inline constexpr const char* diagram_column = "diagram";

}  // namespace stepwire::replay
