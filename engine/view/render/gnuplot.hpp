#pragma once

#include <string>

namespace stepwire::render {

/// Output of gnuplot.
struct GnuplotAnswer {
  std::string output;
  std::string complaints;  ///< standard error
};

/// True if gnuplot is installed.
bool has_gnuplot();

/// Runs gnuplot on a script with its default settings (no start-up file of the user). Throws EnvironmentError
/// if it is missing or fails.
GnuplotAnswer run_gnuplot(const std::string& script);

}  // namespace stepwire::render
