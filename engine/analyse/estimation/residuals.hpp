#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/analyse/query/formula.hpp"

namespace stepwire::estimation {

/// An unknown of a fit: a shared parameter, or a parameter of one fitted record.
struct Unknown {
  std::size_t parameter = 0;
  std::optional<std::size_t> record;  ///< Index of its record; std::nullopt: shared.
};

/// Compared rows of one comparison and record, in SI. The model includes a free offset.
struct ComparedRows {
  double agreement = 0.0;  ///< 100 (1 - |e| / |y - mean y|) [%]; nan for a constant y.
  std::vector<double> time{}, model{}, measured{};
  std::vector<std::vector<double>> against{};
};

/// Prediction of a record by the model.
struct Prediction {
  std::vector<ComparedRows> comparisons;
  std::vector<record::Recording> recordings;
  double squares = 0.0;  ///< Sum of squares of the weighted residuals.
};

using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Weighted differences between model and measurement over all fitted records, as a function of the unknowns
/// (SI).
class Residuals {
 public:
  /// Runs all records with the start values. Throws Error if a run ends early or has nothing to compare.
  Residuals(const ModelRuns& runs, const FitRequest& request, unsigned threads);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const FitParameter& parameter(std::size_t unknown) const {
    return request_.parameters[unknowns_[unknown].parameter];
  }
  Eigen::VectorXd start() const;
  /// Returns the first row of each segment: one per comparison of each fitted record.
  std::vector<Eigen::Index> stretches() const;
  Eigen::Index count() const { return count_; }
  /// Returns the number of free offsets, which reduce the degrees of freedom.
  std::size_t free_offsets() const { return free_offsets_; }
  bool held_out(std::size_t record) const { return held_out_[record]; }
  /// Returns the values of all parameters for a record; unknowns of other records have their start values.
  Values values(std::size_t record, const Eigen::VectorXd& x) const;

  /// Computes the residuals. Returns false if a run ends early or a value is not a number.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const;

  /// Returns the reason why the diagram refuses x, e.g. a damper that gives out energy; empty if it accepts
  /// x.
  std::string refusal(const Eigen::VectorXd& x) const;

  enum class Differences { forward, central };
  /// Computes the residuals and their derivatives, by differences of runs.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Jacobian& jacobian,
                Differences differences) const;
  /// Computes the derivatives; the residuals at x are given.
  bool differentiate(const Eigen::VectorXd& x, const Eigen::VectorXd& residuals, Jacobian& jacobian,
                     Differences differences) const;

  /// Predicts a record from a run with a new plan. Throws Error if the diagram refuses x.
  Prediction predict(std::size_t record, const Eigen::VectorXd& x) const;
  std::size_t rows(std::size_t record) const;

 private:
  /// Compared rows of a record's recording, and their weights.
  struct Selection {
    std::vector<std::size_t> rows;
    std::vector<double> weights;
    std::size_t recorded = 0;  ///< Number of rows of the recording.
  };

  void find_unknowns();
  std::vector<Selection> select(std::size_t record) const;
  Selection select(const FitComparison& comparison, const record::Recording& recording,
                   std::size_t record) const;
  bool differences(std::size_t record, const std::vector<record::Recording>& recordings, double* out) const;
  bool run(std::size_t record, const Values& values, double* out) const;
  ComparedRows compare(const FitComparison& comparison, const Selection& selection,
                       const record::Recording& recording) const;
  Eigen::Index rows_of(std::size_t record) const;
  yaml::Fault fault(const yaml::Place& place, const std::string& message, std::size_t record) const;
  /// Runs a record with one value changed.
  bool run_beside(std::size_t record, std::size_t parameter, Values values, double change, double* out) const;
  /// Computes a column by central differences; false at a bound, or if one side is refused.
  bool central_column(std::size_t record, std::size_t parameter, const Values& at, double step,
                      double* out) const;
  bool column(std::size_t record, std::size_t parameter, const Eigen::VectorXd& x, Differences differences,
              const double* base, double* out) const;

  const ModelRuns& runs_;
  const FitRequest& request_;
  unsigned threads_;
  std::vector<char> held_out_;
  std::vector<std::size_t> fitted_;  ///< Indices of the fitted records.
  std::vector<Unknown> unknowns_;
  std::vector<std::vector<std::optional<std::size_t>>> unknown_of_;  ///< [record][parameter]
  std::vector<std::vector<Selection>> selections_;                   ///< [record][comparison]
  std::vector<Eigen::Index> first_row_;  ///< First row of each fitted record; unused for others.
  Eigen::Index count_ = 0;
  std::size_t free_offsets_ = 0;
};

/// A residual r after the loss: the signed root of 2 rho(r), with rho of Huber or Cauchy, and its derivative
/// by r. Without a loss it is r itself.
struct Counted {
  double value, slope;
};
Counted counted(double r, const FitRequest& request);

/// Replaces the residuals and their derivatives by those after the loss.
void count(const FitRequest& request, Eigen::VectorXd& residuals, Jacobian& jacobian);

/// Returns half of the sum of squares of the residuals after the loss.
double cost_of(const Eigen::VectorXd& residuals, const FitRequest& request);

}  // namespace stepwire::estimation
