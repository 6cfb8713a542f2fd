#pragma once

#include <string>

#include "engine/app/session/comparing.hpp"
#include "engine/app/session/result_comparison.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::report {

/// Returns a comparison in words: a line for each signal, the worst first.
std::string comparison_text(const comparison::RecordingDifference& difference);

/// Returns the differences between the runs of two diagrams in words: a line for each signal that differs or
/// that one run alone has, and for each claim with another verdict.
std::string results_text(const session::ResultComparison& results);

/// Returns the picture of a comparison: both curves of each signal and their difference below, the worst
/// first, of at most `signals` signals.
plot::FigureSpec comparison_figure(const session::ComparedRuns& runs, std::size_t signals = 8);

}  // namespace stepwire::report
