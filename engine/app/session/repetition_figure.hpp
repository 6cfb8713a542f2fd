#pragma once

#include "engine/analyse/study/distribution.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Returns histograms over all experiments of the values that the thesis prints, with a line at the printed
/// value. P values are drawn by their logarithm.
plot::FigureSpec repetition_figure(const std::vector<study::ExperimentOutcome>& experiments,
                                   const study::StudyRequest& request);

}  // namespace stepwire::session
