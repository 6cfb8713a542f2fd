#pragma once

#include <string>

namespace stepwire::io {

/// What comes with the program and is read while it runs lies in one folder, share/stepwire, as folders or
/// links to them: "headers" (of engine and blocks), "public" (those of
/// the library), "eigen" and "precompiled" (for generated code), "drawing"
/// (the module for node), "diagrams", "mpi" (the module for MPI). That folder is the one that $STEPWIRE_HOME
/// names (or the prefix above it), else that of the installed package which a program was built with, else
/// the one beside the running program: in its own folder, or in one of the two above.

/// The path of one of these folders, without links. Throws EnvironmentError with the places where it is not,
/// and how it comes.
std::string resource(const std::string& name);
/// The same; empty where there is none.
std::string find_resource(const std::string& name);

/// Notes the folder share/stepwire of the package that the running program was built with.
void note_package(std::string share);

}  // namespace stepwire::io
