#pragma once

#include "engine/analyse/study/distribution.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Histograms of the values that the thesis prints, over all experiments, with a line at the thesis' value. P
/// is drawn by its logarithm.
plot::FigureSpec repetition_figure(const std::vector<study::ExperimentOutcome>& experiments,
                                   const study::StudyRequest& request);

}  // namespace stepwire::session
