#pragma once

#include "engine/analyse/study/distribution.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire {

/// Histograms of the values that the thesis prints, over all experiments, with a line at the thesis' value. P
/// is drawn by its logarithm.
FigureSpec repetition_figure(const std::vector<ExperimentOutcome>& experiments, const StudyRequest& request);

}  // namespace stepwire
