#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/study_columns.hpp"

namespace stepwire::study {

/// A value that the thesis prints or that is computed from printed ones, with our values by experiment.
struct Distribution {
  std::string name;  ///< "mean.HV", "HV/NO", "p.haptic"
  double published = 0.0;
  std::vector<double> values;  ///< Values of the experiments that have it.
};

/// Returns the distributions of the means and of the ratios that the thesis orders. In each ordered list of
/// conditions the ratios are those to the previous and to the first condition.
std::vector<Distribution> distributions_of_errors(const std::vector<ExperimentOutcome>& experiments,
                                                  const StudyRequest& request);
/// Returns the distributions of P of the factors.
std::vector<Distribution> distributions_of_p(const std::vector<ExperimentOutcome>& experiments,
                                             const StudyRequest& request);

/// Returns a line per error: the thesis' value, our median, and the range of 90 % of the experiments. The
/// last column is their share below the thesis' value.
text::TextTable experiments_table(const std::vector<ExperimentOutcome>& experiments,
                                  const StudyRequest& request);

/// Returns a line per factor with P in the same form. It also has the number of experiments in which the
/// factor significantly lowers the error, and in which it raises it.
text::TextTable experiments_significance_table(const std::vector<ExperimentOutcome>& experiments,
                                               const StudyRequest& request);

}  // namespace stepwire::study
