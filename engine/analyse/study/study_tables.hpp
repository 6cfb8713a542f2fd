#pragma once

#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Returns the empty tables of a study, by their names in `plot: table`.
std::vector<query::NamedTable> empty_study_tables();

/// Fills the tables of one experiment. A table without analysis contains the reason instead.
void fill_study_tables(const Experiment& experiment, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables);

/// Fills the tables of a sweep. The tables `means` and `significance` have a line per point: means, P, and
/// agreement with the statements of the thesis. The others contain the rows of all points.
void fill_sweep_tables(const Experiments& experiments, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables);

/// Returns the source of the trials for titles: "simulated operators", "recorded trials".
std::string whose_trials(const StudyRequest& request);

}  // namespace stepwire::study
