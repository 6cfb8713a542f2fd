#pragma once

#include <string>

// A project of C++ and C that uses two generated diagrams.

/// A part with a parameter of its own.
extern const std::string part_yaml;
/// Parameters that other ones follow, in a part, in lists and matrices, for constants, initial values and
/// members that are prepared; one that cannot change; inputs, noise, several periods.
extern const std::string rig_yaml;
/// Another diagram with the same blocks and names.
extern const std::string rack_yaml;
/// Runs the rig; what it writes is every tick's recorded numbers, then those after a return to tick 60.
extern const std::string cpp_consumer;
/// Runs the rack in the same way, in C; it returns to tick 20.
extern const std::string c_consumer;
/// Builds both consumers with both diagrams.
extern const std::string project;
