#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Of each trial which of its person's it was, and the values that it began with of what is carried; nan
/// where trials were recorded.
std::vector<table::Column> sequence_columns(const Experiment& experiment, const StudyRequest& request,
                                            const diagram::Diagram& diagram);

}  // namespace stepwire::study
