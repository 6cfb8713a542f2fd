#pragma once

#include <string>

namespace stepwire::render {

/// What gnuplot said.
struct GnuplotAnswer {
  std::string output;
  std::string complaints;  ///< its standard error
};

/// Whether gnuplot can be found.
bool has_gnuplot();

/// Runs gnuplot on a script with its default settings (no start-up file of the user). Throws
/// EnvironmentError where it is missing or fails.
GnuplotAnswer run_gnuplot(const std::string& script);

}  // namespace stepwire::render
