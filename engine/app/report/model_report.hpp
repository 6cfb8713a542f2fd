#pragma once

#include <string>
#include <vector>

#include "engine/app/session/monitor.hpp"
#include "engine/app/session/session.hpp"
#include "engine/view/gallery/report_page.hpp"

namespace stepwire::report {

/// Loads, runs and draws a diagram file for a report: drawing, parts opened, figures, claims, parameters,
/// records, coverage, versions. A file that cannot be run has its fault in the entry. A drawing or a figure
/// that a missing program would make is left out, with a note.
gallery::Report model_report(const Registry& registry, const std::string& file,
                             const session::LoadOptions& options, const session::Monitor& monitor);

/// Returns the diagram files of a path: itself, or those of a folder, sorted, without parts. Throws Error for
/// a folder without one.
std::vector<std::string> diagram_files(const std::string& path);

/// Prints a page by Chromium. Throws EnvironmentError if it is missing or fails.
void print_page(const std::string& html, const std::string& pdf);

}  // namespace stepwire::report
