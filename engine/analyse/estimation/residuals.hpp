#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/model_runs.hpp"

namespace stepwire::estimation {

/// What a fit finds: a number for each shared parameter, and for each other one a number for each record that
/// is fitted.
struct Unknown {
  std::size_t parameter = 0;
  std::optional<std::size_t> record;  ///< whose own it is
};

/// What a comparison of one record came to: its compared rows, in SI. Where the offset is free, the model has
/// it.
struct ComparedRows {
  double agreement = 0.0;  ///< 100 (1 - |e| / |y - mean y|) [%]; nan where y is constant
  std::vector<double> time{}, model{}, measured{};
  std::vector<std::vector<double>> against{};
};

/// A record as the model predicts it.
struct Prediction {
  std::vector<ComparedRows> comparisons;
  std::vector<record::Recording> recordings;
  double squares = 0.0;  ///< sum of the weighted residuals' squares
};

using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Weighted differences between model and measurement over all fitted records, as a function of the unknowns
/// (SI).
class Residuals {
 public:
  /// Runs all records with the start values. Throws Error where one of them ends early or has nothing to
  /// compare.
  Residuals(const ModelRuns& runs, const FitRequest& request, unsigned threads);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const FitParameter& parameter(std::size_t unknown) const {
    return request_.parameters[unknowns_[unknown].parameter];
  }
  Eigen::VectorXd start() const;
  /// Rows at which stretches of residuals begin: one for each comparison of each fitted record.
  std::vector<Eigen::Index> stretches() const;
  Eigen::Index count() const { return count_; }
  /// Means that are free and count against the degrees of freedom.
  std::size_t free_offsets() const { return free_offsets_; }
  bool held_out(std::size_t record) const { return held_out_[record]; }
  /// Values of all parameters for a record; what is another record's own is at its start.
  Values values(std::size_t record, const Eigen::VectorXd& x) const;

  /// False where a run ends early or gives what is no number.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const;

  /// Why the diagram refuses x, e.g. as a damper that gives out energy; empty where it takes it.
  std::string refusal(const Eigen::VectorXd& x) const;

  enum class Differences { forward, central };
  /// Also the derivatives, by differences of runs.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Jacobian& jacobian,
                Differences differences) const;
  /// The derivatives alone, where the residuals at x are known.
  bool differentiate(const Eigen::VectorXd& x, const Eigen::VectorXd& residuals, Jacobian& jacobian,
                     Differences differences) const;

  /// How a record is predicted, from a run that is planned anew. Throws Error where the diagram refuses x.
  Prediction predict(std::size_t record, const Eigen::VectorXd& x) const;
  std::size_t rows(std::size_t record) const;

 private:
  /// Which rows of a record's recording are compared, and how they count.
  struct Selection {
    std::vector<std::size_t> rows;
    std::vector<double> weights;
    std::size_t recorded = 0;  ///< rows of the recording
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
  /// Runs a record with one of these values changed.
  bool run_beside(std::size_t record, std::size_t parameter, Values values, double change, double* out) const;
  /// False at a bound, or where one side is refused.
  bool central_column(std::size_t record, std::size_t parameter, const Values& at, double step,
                      double* out) const;
  bool column(std::size_t record, std::size_t parameter, const Eigen::VectorXd& x, Differences differences,
              const double* base, double* out) const;

  const ModelRuns& runs_;
  const FitRequest& request_;
  unsigned threads_;
  std::vector<char> held_out_;
  std::vector<std::size_t> fitted_;  ///< records
  std::vector<Unknown> unknowns_;
  std::vector<std::vector<std::optional<std::size_t>>> unknown_of_;  ///< [record][parameter]
  std::vector<std::vector<Selection>> selections_;                   ///< [record][comparison]
  std::vector<Eigen::Index> first_row_;  ///< of each fitted record; of no use for others
  Eigen::Index count_ = 0;
  std::size_t free_offsets_ = 0;
};

}  // namespace stepwire::estimation
