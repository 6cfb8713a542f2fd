#include "engine/analyse/estimation/residuals.hpp"
#include "engine/base/text/count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace stepwire::estimation {
namespace {

// Shares of a parameter's size. The error of a derivative is of this order for forward differences, of its
// square for central ones. The rounding error of a run (about 1e-12) over the share is smaller. Larger shares
// would be too inaccurate for waves of many periods, which bend within a thousandth of a parameter.
constexpr double forward_step = 1e-6, central_step = 2e-5;

bool is_true(double value) {
  return value != 0.0 && !std::isnan(value);
}

/// Returns the value of a formula of swept parameters.
double value_of(const query::Formula& formula, const std::vector<table::Column>& swept) {
  std::vector<double> values;
  for (const std::string& name : formula.columns)
    for (const table::Column& column : swept)
      if (column.name == name) values.push_back(column.values.front());
  return formula.expression(values);
}

/// Returns the value of a formula in each row of a recording; a formula that is a column is not evaluated.
std::vector<double> values_of(const query::Formula& formula, const record::Recording& recording) {
  if (formula.columns.size() == 1 && formula.text == formula.expression.variables().front())
    if (const table::Column* column = recording.table.find(formula.columns.front())) return column->values;
  return query::evaluate(formula, recording);
}

std::vector<double> values_or_one(const std::optional<query::Formula>& formula,
                                  const record::Recording& recording, std::size_t rows) {
  return formula ? values_of(*formula, recording) : std::vector<double>(rows, 1.0);
}

std::string no_number(const std::string& text, double value, double time) {
  return fmt::format("'{}' is {} at {} s; leave such rows out by 'where'", text, value, time);
}

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

std::string too_few_rows(Eigen::Index rows, std::size_t unknown) {
  return fmt::format("{} rows are compared, too few for {}", rows, text::counted(unknown, "unknown number"));
}

}  // namespace

Residuals::Residuals(const ModelRuns& runs, const FitRequest& request, unsigned threads)
    : runs_(runs), request_(request), threads_(threads) {
  const bool sought = !request.parameters.empty();  // else no record is held out
  for (std::size_t record = 0; record < runs.records(); ++record) {
    const bool held = sought && request.hold_out && is_true(value_of(*request.hold_out, runs.swept(record)));
    held_out_.push_back(held);
    if (!held) fitted_.push_back(record);
  }
  if (fitted_.empty())
    throw yaml::Error(
        yaml::Fault{request.place, "fit.hold_out", "holds out every record; leave some to be fitted", {}});
  selections_.resize(runs.records());
  runs.in_parallel(runs.records(), threads,
                   [&](std::size_t record) { selections_[record] = select(record); });
  find_unknowns();
  first_row_.assign(runs.records(), 0);
  for (std::size_t record : fitted_) {
    first_row_[record] = count_;
    count_ += rows_of(record);
    for (const FitComparison& comparison : request.comparisons) free_offsets_ += comparison.free_offset;
  }
  const std::size_t sought_numbers = unknowns_.size() + free_offsets_;
  if (sought && static_cast<std::size_t>(count_) <= sought_numbers)
    throw yaml::Error(yaml::Fault{request.place, "fit", too_few_rows(count_, sought_numbers), {}});
}

void Residuals::find_unknowns() {
  unknown_of_.assign(runs_.records(), std::vector<std::optional<std::size_t>>(request_.parameters.size()));
  for (std::size_t j = 0; j < request_.parameters.size(); ++j) {
    if (!request_.parameters[j].each_record) {
      for (auto& of_record : unknown_of_) of_record[j] = unknowns_.size();
      unknowns_.push_back({j, std::nullopt});
      continue;
    }
    for (std::size_t record : fitted_) {
      unknown_of_[record][j] = unknowns_.size();
      unknowns_.push_back({j, record});
    }
  }
}

yaml::Fault Residuals::fault(const yaml::Place& place, const std::string& message, std::size_t record) const {
  const std::string& label = runs_.label(record);
  return {place, "fit", label.empty() ? message : fmt::format("{} (in the record {})", message, label), {}};
}

std::vector<Residuals::Selection> Residuals::select(std::size_t record) const {
  Values start;
  for (const FitParameter& parameter : request_.parameters) start.push_back(parameter.start);
  std::string why;
  const std::vector<record::Recording> recordings = runs_.run(record, start, &why);
  if (recordings.empty())
    throw yaml::Error(fault(request_.place, "the run with the start values ended early: " + why, record));
  std::vector<Selection> selections;
  for (const FitComparison& comparison : request_.comparisons)
    selections.push_back(select(comparison, recordings[comparison.recording], record));
  return selections;
}

Residuals::Selection Residuals::select(const FitComparison& comparison, const record::Recording& recording,
                                       std::size_t record) const {
  const std::vector<double> measured = values_of(comparison.measured, recording);
  const std::vector<double> where = values_or_one(comparison.where, recording, measured.size());
  const std::vector<double> weight = values_or_one(comparison.weight, recording, measured.size());
  Selection selection;
  selection.recorded = measured.size();
  for (std::size_t row = 0; row < measured.size(); ++row) {
    if (!is_true(where[row])) continue;
    const double time = recording.table.columns.front().values[row];
    if (!std::isfinite(weight[row]))
      throw yaml::Error(
          fault(comparison.place, no_number(comparison.weight->text, weight[row], time), record));
    if (!std::isfinite(measured[row]))
      throw yaml::Error(
          fault(comparison.place, no_number(comparison.measured.text, measured[row], time), record));
    selection.rows.push_back(row);
    selection.weights.push_back(weight[row]);
  }
  if (selection.rows.empty())
    throw yaml::Error(fault(
        comparison.place,
        comparison.where ? fmt::format("'{}' selects no row", comparison.where->text) : "nothing is recorded",
        record));
  return selection;
}

Eigen::Index Residuals::rows_of(std::size_t record) const {
  return static_cast<Eigen::Index>(rows(record));
}

std::size_t Residuals::rows(std::size_t record) const {
  std::size_t rows = 0;
  for (const Selection& selection : selections_[record]) rows += selection.rows.size();
  return rows;
}

Eigen::VectorXd Residuals::start() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(unknowns_.size()));
  for (std::size_t i = 0; i < unknowns_.size(); ++i) x[static_cast<Eigen::Index>(i)] = parameter(i).start;
  return x;
}

std::vector<Eigen::Index> Residuals::stretches() const {
  std::vector<Eigen::Index> starts;
  for (const std::size_t record : fitted_) {
    Eigen::Index first = first_row_[record];
    for (const Selection& selection : selections_[record]) {
      starts.push_back(first);
      first += static_cast<Eigen::Index>(selection.rows.size());
    }
  }
  return starts;
}

Values Residuals::values(std::size_t record, const Eigen::VectorXd& x) const {
  Values values;
  for (std::size_t j = 0; j < request_.parameters.size(); ++j) {
    const auto unknown = unknown_of_[record][j];
    values.push_back(unknown ? x[static_cast<Eigen::Index>(*unknown)] : request_.parameters[j].start);
  }
  return values;
}

bool Residuals::differences(std::size_t record, const std::vector<record::Recording>& recordings,
                            double* out) const {
  for (std::size_t c = 0; c < request_.comparisons.size(); ++c) {
    const FitComparison& comparison = request_.comparisons[c];
    const Selection& selection = selections_[record][c];
    const std::vector<double> model = values_of(comparison.model.formula, recordings[comparison.recording]);
    const std::vector<double> measured = values_of(comparison.measured, recordings[comparison.recording]);
    if (model.size() != selection.recorded) return false;  // it stopped at another time
    double sum = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < selection.rows.size(); ++i) {
      const double square = selection.weights[i] * selection.weights[i];
      out[i] = model[selection.rows[i]] - measured[selection.rows[i]];
      sum += square * out[i];
      weights += square;
    }
    const double offset = comparison.free_offset && weights > 0.0 ? sum / weights : 0.0;
    for (std::size_t i = 0; i < selection.rows.size(); ++i) {
      out[i] = selection.weights[i] * (out[i] - offset);
      if (!std::isfinite(out[i])) return false;
    }
    out += selection.rows.size();
  }
  return true;
}

bool Residuals::run(std::size_t record, const Values& values, double* out) const {
  const std::vector<record::Recording> recordings = runs_.run(record, values);
  return !recordings.empty() && differences(record, recordings, out);
}

bool Residuals::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
  residuals.resize(count_);
  std::atomic<bool> good = true;
  runs_.in_parallel(fitted_.size(), threads_, [&](std::size_t i) {
    const std::size_t record = fitted_[i];
    if (good && !run(record, values(record, x), residuals.data() + first_row_[record])) good = false;
  });
  return good;
}

std::string Residuals::refusal(const Eigen::VectorXd& x) const {
  const bool alike = unknowns_.size() == request_.parameters.size();  // for all records
  for (const std::size_t record : fitted_) {
    std::string why = runs_.refusal(record, values(record, x));
    if (!why.empty() || alike) return why;
  }
  return "";
}

bool Residuals::run_beside(std::size_t record, std::size_t parameter, Values values, double change,
                           double* out) const {
  values[parameter] += change;
  return run(record, values, out);
}

bool Residuals::central_column(std::size_t record, std::size_t parameter, const Values& at, double step,
                               double* out) const {
  const FitParameter& of = request_.parameters[parameter];
  std::vector<double> below(rows(record));
  if (!(at[parameter] - step >= of.lower && at[parameter] + step <= of.upper)) return false;
  if (!run_beside(record, parameter, at, step, out) ||
      !run_beside(record, parameter, at, -step, below.data()))
    return false;
  for (std::size_t i = 0; i < below.size(); ++i) out[i] = (out[i] - below[i]) / (2.0 * step);
  return true;
}

bool Residuals::column(std::size_t record, std::size_t parameter, const Eigen::VectorXd& x,
                       Differences differences, const double* base, double* out) const {
  const FitParameter& of = request_.parameters[parameter];
  const Values at = values(record, x);
  const double size = std::max(std::abs(at[parameter]), 0.1 * of.scale);
  if (differences == Differences::central && central_column(record, parameter, at, central_step * size, out))
    return true;
  double step = forward_step * size;  // also at a bound, or if one side is refused
  if (at[parameter] + step > of.upper) step = -step;
  if (!run_beside(record, parameter, at, step, out)) {
    step = -step;
    if (!run_beside(record, parameter, at, step, out)) return false;
  }
  const std::size_t count = rows(record);
  for (std::size_t i = 0; i < count; ++i) out[i] = (out[i] - base[i]) / step;
  return true;
}

bool Residuals::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Jacobian& jacobian,
                         Differences differences) const {
  return evaluate(x, residuals) && differentiate(x, residuals, jacobian, differences);
}

bool Residuals::differentiate(const Eigen::VectorXd& x, const Eigen::VectorXd& residuals, Jacobian& jacobian,
                              Differences differences) const {
  jacobian.setZero(count_, x.size());
  const std::size_t parameters = request_.parameters.size();
  std::atomic<bool> good = true;
  runs_.in_parallel(fitted_.size() * parameters, threads_, [&](std::size_t task) {
    const std::size_t record = fitted_[task / parameters], parameter = task % parameters;
    const Eigen::Index first = first_row_[record], rows = rows_of(record);
    Eigen::VectorXd slope(rows);
    if (!good || !column(record, parameter, x, differences, residuals.data() + first, slope.data())) {
      good = false;
      return;
    }
    jacobian.col(static_cast<Eigen::Index>(*unknown_of_[record][parameter])).segment(first, rows) = slope;
  });
  return good;
}

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

Counted counted(double r, const FitRequest& request) {
  const double width = request.width, size = std::abs(r);
  if (request.loss == FitLoss::huber && size > width) {
    const double value = std::sqrt(width * (2.0 * size - width));
    return {std::copysign(value, r), width / value};
  }
  if (request.loss == FitLoss::cauchy && size > 1e-6 * width) {
    const double share = r * r / (width * width), value = width * std::sqrt(std::log1p(share));
    return {std::copysign(value, r), size / (1.0 + share) / value};
  }
  return {r, 1.0};
}

void count(const FitRequest& request, Eigen::VectorXd& residuals, Jacobian& jacobian) {
  if (request.loss == FitLoss::none) return;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const Counted one = counted(residuals[i], request);
    residuals[i] = one.value;
    if (jacobian.rows() == residuals.size()) jacobian.row(i) *= one.slope;
  }
}

double cost_of(const Eigen::VectorXd& residuals, const FitRequest& request) {
  double sum = 0.0;
  for (const double r : residuals) {
    const double value = counted(r, request).value;
    sum += value * value;
  }
  return 0.5 * sum;
}

}  // namespace stepwire::estimation
