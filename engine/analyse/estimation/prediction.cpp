// Predictions of single records, for reports and pictures.
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/analyse/estimation/residuals.hpp"
#include "engine/analyse/estimation/row_values.hpp"

namespace stepwire::estimation {

namespace {

constexpr double rounding = 1e-13;  // relative rounding error of a mean

double norm(const std::vector<double>& values) {
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void subtract(double offset, std::vector<double>& values) {
  for (double& value : values) value -= offset;
}

}  // namespace

Prediction Residuals::predict(std::size_t record, const Eigen::VectorXd& x) const {
  std::string why;
  Prediction prediction;
  prediction.recordings = runs_.run_anew(record, values(record, x), &why);
  if (prediction.recordings.empty())
    throw yaml::Error(fault(request_.place, "the run ended early: " + why, record));
  std::vector<double> weighted(rows(record));
  if (!differences(record, prediction.recordings, weighted.data()))
    throw yaml::Error(fault(request_.place, "the model gives what is no number", record));
  for (double one : weighted) prediction.squares += one * one;
  for (std::size_t c = 0; c < request_.comparisons.size(); ++c) {
    const FitComparison& comparison = request_.comparisons[c];
    prediction.comparisons.push_back(
        compare(comparison, selections_[record][c], prediction.recordings[comparison.recording]));
  }
  return prediction;
}

ComparedRows Residuals::compare(const FitComparison& comparison, const Selection& selection,
                                const record::Recording& recording) const {
  const auto rows_of_formula = [&](const query::Formula& formula) {
    const std::vector<double> all = values_of(formula, recording);
    std::vector<double> chosen;
    for (std::size_t row : selection.rows) chosen.push_back(all[row]);
    return chosen;
  };
  ComparedRows rows;
  for (std::size_t row : selection.rows) rows.time.push_back(recording.table.columns.front().values[row]);
  rows.model = rows_of_formula(comparison.model.formula);
  rows.measured = rows_of_formula(comparison.measured);
  for (const query::Series& series : comparison.against)
    rows.against.push_back(rows_of_formula(series.formula));
  std::vector<double> error = rows.model, spread = rows.measured;
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= rows.measured[i];
  if (comparison.free_offset) {
    const double offset = mean_of(error);
    for (std::size_t i = 0; i < error.size(); ++i) rows.model[i] -= offset;
    subtract(offset, error);
  }
  const double size = norm(spread);
  subtract(mean_of(spread), spread);
  const bool constant = norm(spread) <= rounding * size;
  rows.agreement =
      constant ? std::numeric_limits<double>::quiet_NaN() : 100.0 * (1.0 - norm(error) / norm(spread));
  return rows;
}

}  // namespace stepwire::estimation
