#pragma once

#include <string>
#include <vector>

#include "engine/figure/names.hpp"
#include "engine/study/experiment.hpp"

namespace stepwire {

/// The tables that a study makes, by the names that `plot: table` has for them, still empty.
std::vector<NamedTable> empty_study_tables();

/// Fills them in. What cannot be analysed is said in the table's place.
void fill_study_tables(const Experiment& experiment, const StudyRequest& request,
                       std::vector<NamedTable>& tables);

/// Whose trials they are, for titles: "simulated operators", "recorded trials".
std::string whose_trials(const StudyRequest& request);

}  // namespace stepwire
