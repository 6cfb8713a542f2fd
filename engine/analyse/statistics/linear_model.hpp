#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// The columns of a term in a linear model: factors coded so that their levels sum to zero, interactions by
/// products. Columns that those before them determine are left out.
struct TermColumns {
  Term term;
  Eigen::MatrixXd columns;           ///< [observation][column], independent of each other and of those before
  Eigen::Index wanted = 0;           ///< number of columns that the term should have
  std::vector<std::string> same_as;  ///< names of the terms that determine what was left out
};

/// The terms of a model behind its constant.
std::vector<TermColumns> model_columns(const Observations& observations, const std::vector<Term>& terms);

/// The part of a response that the constant and some terms explain.
Eigen::VectorXd explained(const Eigen::VectorXd& response, const std::vector<const TermColumns*>& terms);

}  // namespace stepwire::statistics
