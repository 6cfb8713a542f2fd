#pragma once

#include <string>

namespace stepwire::io {

/// Files that the program reads at run time are in one folder, share/stepwire, as subfolders or links. These
/// are "headers" (engine and blocks), "public" (the library), "eigen" and "precompiled" (for generated code).
/// The others are "drawing" (module for node), "diagrams" and "mpi" (module for MPI). The folder is the one
/// that $STEPWIRE_HOME names, or the one below that prefix. Without that variable it is that of the package
/// that a program was built with. The last choice is a folder beside the running program or up to two levels
/// above.

/// Returns the path of such a subfolder, without links. If it is missing, throws EnvironmentError with the
/// searched locations and how to install it.
std::string resource(const std::string& name);
/// Returns the same path; empty if it is missing.
std::string find_resource(const std::string& name);

/// Sets the folder share/stepwire of the package that the running program was built with.
void note_package(std::string share);

}  // namespace stepwire::io
