#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/outcome_columns.hpp"

namespace stepwire::study {

/// A value that the thesis prints or that follows from such ones, and what it came out as in each experiment.
struct Distribution {
  std::string name;  ///< "mean.HV", "HV/NO", "p.haptic"
  double published = 0.0;
  std::vector<double> values;  ///< of the experiments that have it
};

/// Of the means, and of the ratios that the text of the thesis is about: of each list of conditions that it
/// orders, each over the one before it and over the first.
std::vector<Distribution> distributions_of_errors(const std::vector<ExperimentOutcome>& experiments,
                                                  const StudyRequest& request);
/// Of P of the factors.
std::vector<Distribution> distributions_of_p(const std::vector<ExperimentOutcome>& experiments,
                                             const StudyRequest& request);

/// For each of the errors: the thesis', our median, the range in which 90 % of the experiments lie, and the
/// part of them that lies below the thesis' value.
text::TextTable experiments_table(const std::vector<ExperimentOutcome>& experiments,
                                  const StudyRequest& request);

/// For each factor P in the same way, and in how many experiments it is significant and lowers the error, or
/// raises it.
text::TextTable experiments_significance_table(const std::vector<ExperimentOutcome>& experiments,
                                               const StudyRequest& request);

}  // namespace stepwire::study
