#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Returns, by trial, its number among the person's trials and the values that it received from the trial
/// before. Nan for recorded trials.
std::vector<table::Column> sequence_columns(const Experiment& experiment, const StudyRequest& request,
                                            const diagram::Diagram& diagram);

}  // namespace stepwire::study
