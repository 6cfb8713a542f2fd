#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Columns of a term in a linear model. Factors are coded so that their levels sum to zero; interactions are
/// products. Columns that are linear combinations of earlier ones are left out.
struct TermColumns {
  Term term;
  Eigen::MatrixXd columns;           ///< [observation][column], linearly independent of earlier ones.
  Eigen::Index wanted = 0;           ///< Number of columns without collinearity.
  std::vector<std::string> same_as;  ///< Names of the terms that determine the omitted columns.
};

/// Returns the columns of the terms of a model; the constant comes before them.
std::vector<TermColumns> model_columns(const Observations& observations, const std::vector<Term>& terms);

/// Returns the part of a response that the constant and some terms explain. Rows of the model count with the
/// squares of `roots`. The response and the result are multiplied by `roots`.
Eigen::VectorXd explained(const Eigen::VectorXd& response, const std::vector<const TermColumns*>& terms,
                          const Eigen::VectorXd& roots);

}  // namespace stepwire::statistics
