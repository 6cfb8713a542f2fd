#include "engine/analyse/estimation/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "engine/analyse/estimation/certainty.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/least_squares.hpp"
#include "engine/analyse/estimation/searches.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::estimation {
namespace {

constexpr int intervals = 120;
constexpr double difference = 1e-6;  // as a share of a parameter's size

class Evaluation {
 public:
  Evaluation(const FitCurve& curve, const std::vector<std::string>& names)
      : curve_(curve), formula_(curve.y.formula), names_(names) {}

  double at(double variable, const Eigen::VectorXd& x) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < formula_.columns.size(); ++i) values.push_back(value_of(i, variable, x));
    return formula_.expression(values);
  }

  Eigen::VectorXd slopes(double variable, const Eigen::VectorXd& x) const {
    Eigen::VectorXd slopes(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double step = difference * (x[i] == 0.0 ? 1.0 : std::abs(x[i]));
      Eigen::VectorXd above = x, below = x;
      above[i] += step;
      below[i] -= step;
      slopes[i] = (at(variable, above) - at(variable, below)) / (2.0 * step);
    }
    return slopes;
  }

 private:
  double value_of(std::size_t i, double variable, const Eigen::VectorXd& x) const {
    const std::string& column = formula_.columns[i];
    if (column == curve_.variable) return variable;
    const auto found = std::find(names_.begin(), names_.end(), column);
    return found == names_.end() ? curve_.otherwise[i] : x[static_cast<Eigen::Index>(found - names_.begin())];
  }

  const FitCurve& curve_;
  const query::Formula& formula_;
  const std::vector<std::string>& names_;
};

/// True for a block with a state and an input. A source may have a state, too, e.g. that of a random number.
bool has_memory(const plan::PlannedBlock& block) {
  return std::ranges::any_of(block.states, [](const plan::SignalSlot& state) { return state.size > 0; }) &&
         std::ranges::any_of(block.inputs, [](const auto& port) { return !port.empty(); });
}

/// True if the compared rows are a time series: by the key of the request, or if the diagram has memory.
/// Memory is a block with a state and an input. Rows of a diagram without memory are points of a function, in
/// any order.
bool in_time(const plan::Plan& plan, const FitRequest& request) {
  return request.standard_errors == StandardErrors::serial || std::ranges::any_of(plan.blocks, has_memory);
}

/// Returns the kind of standard errors of the intervals: that of the request, or the default for the rows'
/// order.
StandardErrors used_errors(const FitRequest& request, bool in_time) {
  if (request.standard_errors != StandardErrors::automatic) return request.standard_errors;
  return in_time ? StandardErrors::serial : StandardErrors::classical;
}

/// Evaluates a curve at the unknowns x of these names. The interval is that of the linearised function (delta
/// method); `quantile` is that of Student's t.
FittedCurve fitted_curve(const FitCurve& curve, const std::vector<std::string>& names,
                         const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, double quantile) {
  FittedCurve fitted{curve.y.label, curve.y.unit_text, curve.label, curve.y.formula.dimension};
  const Evaluation evaluation(curve, names);
  for (int k = 0; k <= intervals; ++k) {
    const double at = curve.from + (curve.to - curve.from) * k / intervals;
    const double value = evaluation.at(at, x);
    const Eigen::VectorXd slopes = evaluation.slopes(at, x);
    const double half = quantile * std::sqrt(std::max(0.0, slopes.dot(covariance * slopes)));
    fitted.at.push_back(at);
    fitted.value.push_back(value);
    fitted.low.push_back(value - half);
    fitted.high.push_back(value + half);
  }
  return fitted;
}

/// Extends the range of the data by that of a run's recordings.
void add_data(const FitCurve& curve, std::span<const record::Recording> recordings, FittedCurve& fitted) {
  if (!curve.data) return;
  for (const double value : query::evaluate(*curve.data, recordings[curve.recording])) {
    if (!std::isfinite(value)) continue;
    if (fitted.data_range.empty()) fitted.data_range = {value, value};
    fitted.data_range = {std::min(fitted.data_range[0], value), std::max(fitted.data_range[1], value)};
  }
}

/// The steps of a fit. Parameters without effect at the start are faults. Differential evolution, if
/// requested, adds a start. Searches begin from all starts; the best minimum is refined with central
/// differences, which also give the standard errors. Then each record is predicted by a run with a new plan,
/// and the numbers are described.
class Fit {
 public:
  Fit(const ModelSource& source, const run::Job& job, const FitRequest& request, const FitOptions& options)
      : source_(source),
        request_(request),
        options_(options),
        runs_(source, job, request),
        residuals_(runs_, request, options.threads) {
    result_.in_time = in_time(job.plan, request);
    result_.standard_errors = used_errors(request, result_.in_time);
  }

  FitResult result() {
    if (request_.parameters.empty())
      take_as_it_is();
    else
      search_parameters();
    predict();
    result_.compiled = runs_.compiled();
    result_.in_part = runs_.in_part();
    result_.interrupted = interrupted();
    describe_numbers();
    for (std::string& doubt : doubts_of(result_)) result_.findings.push_back(std::move(doubt));
    set_parameters();
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    return std::move(result_);
  }

 private:
  void search_parameters() {
    refuse_idle_parameters();
    search();
  }

  /// Sets the result without a search, as the call sets all parameters: records are only predicted.
  void take_as_it_is() {
    Eigen::VectorXd r;
    if (residuals_.evaluate(best_.x, r)) best_.cost = cost_of(r, request_);
    best_.converged = result_.converged = true;
  }

  bool interrupted() const { return source_.interrupt && *source_.interrupt; }

  void tell(double fraction, const std::string& what) const {
    if (options_.progress) options_.progress(fraction, what);
  }

  /// Throws Error for parameters without any effect at the start; they would have none later.
  void refuse_idle_parameters() {
    KnownPoint start{residuals_.start(), {}, {}};
    if (!residuals_.evaluate(start.x, start.residuals, start.slopes, Residuals::Differences::forward)) return;
    const Eigen::VectorXd lengths = start.slopes.colwise().norm();
    yaml::Faults faults;
    for (Eigen::Index i = 0; i < lengths.size(); ++i) {
      const FitParameter& parameter = residuals_.parameter(static_cast<std::size_t>(i));
      if (lengths[i] == 0.0)
        faults.add({parameter.place,
                    "fit.parameters." + parameter.name,
                    "moves nothing that is compared; take it out of the fit, or compare what it moves",
                    {}});
    }
    faults.throw_if_any();
    start_ = std::move(start);
  }

  Minimum descend(const SearchStart& start, double done, double share, const std::string& what) const {
    LeastSquaresOptions options{start.iterations, source_.interrupt, {}, start_};
    options.watch = [&](std::size_t step, double cost) {
      const double part = 1.0 - std::exp(-static_cast<double>(step) / 8.0);  // the number of steps is unknown
      tell(done + share * part, fmt::format("{}, step {}: cost {:.5g}", what, step, cost));
    };
    return minimise(residuals_, request_, start.from, options);
  }

  void search() {
    std::vector<Eigen::VectorXd> starts = make_starts(residuals_, request_);
    if (request_.global)
      starts.push_back(evolve(residuals_, request_, source_.interrupt, [&](std::size_t g, double cost) {
        tell(0.3 * static_cast<double>(g) / static_cast<double>(request_.global->generations),
             fmt::format("generation {}: cost {:.5g}", g, cost));
      }));
    const Searches searches(request_, source_.interrupt, options_.workers,
                            [this](const SearchStart& start, double done, double share,
                                   const std::string& what) { return descend(start, done, share, what); });
    const std::vector<Minimum> minima = searches.from(starts);
    best_ = minima[ranking(minima).front()];
    for (const Minimum& one : minima) result_.starts.push_back({one.cost, one.converged, one.iterations});
    if (!std::isfinite(best_.cost) && !interrupted())
      throw yaml::Error(
          yaml::Fault{request_.place, "fit", "no start can be evaluated; give a start that runs", {}});
    if (!std::isfinite(best_.cost)) best_ = {residuals_.start(), 0.0};
    result_.converged = best_.converged;
    if (!(best_.converged || best_.stalled) || interrupted()) return;
    Refined refined = refine(residuals_, request_, std::move(best_), source_.interrupt);
    best_ = std::move(refined.minimum);
    end_ = std::move(refined.at);
  }

  /// Decides whether the search has ended at a minimum. The cost may also fall towards values that the
  /// diagram refuses, which have no cost themselves.
  void judge_end(const Eigen::VectorXd& r, const Jacobian& slopes) {
    std::vector<FallingUnknown> falling = still_falling(residuals_, request_, best_.x, r, slopes);
    std::erase_if(falling, [&](const FallingUnknown& one) {
      return result_.numbers[static_cast<std::size_t>(one.unknown)].at_bound;
    });
    result_.limited = !falling.empty() && !best_.refusal.empty();
    result_.converged = best_.converged || best_.stalled;
    if (result_.limited)
      result_.findings.push_back("the records want what the diagram refuses: " + best_.refusal);
    else if (result_.converged && !falling.empty())
      leave_astray(falling_text(falling, titles()));
  }

  /// Adds a finding by which the end of the search is no minimum. A search that has not ended remains so.
  void leave_astray(std::string why) {
    result_.astray = result_.astray || result_.converged;
    result_.converged = false;
    result_.findings.push_back(std::move(why));
  }

  double predict() {
    double squares = 0.0;
    result_.records.clear();
    result_.curves.assign(request_.curves.size(), FittedCurve{});
    for (std::size_t record = 0; record < runs_.records(); ++record) {
      FittedRecord one{runs_.label(record), residuals_.held_out(record), residuals_.rows(record)};
      double own = 0.0;
      try {
        if (!interrupted()) own = take(residuals_.predict(record, best_.x), one);
      } catch (const yaml::Error& error) {
        if (!result_.refused)
          result_.findings.push_back(fmt::format(
              "the records want what the diagram does not take; give narrower bounds: {}", error.what()));
        result_.refused = true;
      }
      if (!one.held_out) squares += own;
      result_.records.push_back(std::move(one));
    }
    return squares;
  }

  double take(Prediction prediction, FittedRecord& record) {
    record.comparisons = std::move(prediction.comparisons);
    for (std::size_t i = 0; i < request_.curves.size() && !record.held_out; ++i)
      add_data(request_.curves[i], prediction.recordings, result_.curves[i]);
    return prediction.squares;
  }

  void describe_numbers() {
    result_.cost = best_.cost;
    result_.freedom = static_cast<double>(residuals_.count() - best_.x.size()) -
                      static_cast<double>(residuals_.free_offsets());
    for (std::size_t i = 0; i < residuals_.unknowns().size(); ++i) result_.numbers.push_back(number(i));
    if (result_.numbers.empty() || interrupted() || !differentiate()) return;
    count(request_, end_.residuals, end_.slopes);
    judge_end(end_.residuals, end_.slopes);
    describe_certainty(certainty_of(end_.residuals, end_.slopes, sizes(), result_.freedom,
                                    {residuals_.stretches(), result_.in_time, result_.standard_errors}));
  }

  /// Computes the derivatives at the end by central differences, unless refine() has done so.
  bool differentiate() {
    return (end_.slopes.size() > 0 && end_.x == best_.x) ||
           residuals_.evaluate(best_.x, end_.residuals, end_.slopes, Residuals::Differences::central);
  }

  /// True if the start has fewer free directions than the end.
  bool known_at_start(const Certainty& certainty) const {
    return start_.slopes.size() > 0 &&
           Resolution::of(start_.slopes).free.size() < certainty.free_directions.size();
  }

  /// Returns the references of relative changes of the unknowns.
  Eigen::VectorXd sizes() const {
    Eigen::VectorXd sizes = best_.x;
    for (Eigen::Index i = 0; i < sizes.size(); ++i)
      if (sizes[i] == 0.0) sizes[i] = residuals_.parameter(static_cast<std::size_t>(i)).scale;
    return sizes;
  }

  std::vector<std::string> titles() const {
    std::vector<std::string> titles;
    for (const FittedNumber& one : result_.numbers) titles.push_back(one.title());
    return titles;
  }

  void describe_certainty(const Certainty& certainty) {
    const std::vector<std::string> titles = this->titles();
    result_.deviation = certainty.deviation;
    result_.correlation = certainty.correlation;
    result_.together = certainty.serial.rows;
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      FittedNumber& one = result_.numbers[i];
      one.standard_error = certainty.standard_errors[at];
      one.classical_error = certainty.classical[at];
      if (result_.in_time) one.serial_error = certainty.of_series[at];
      one.low = one.value - certainty.half_widths[at];
      one.high = one.value + certainty.half_widths[at];
    }
    for (std::size_t i = 0; i < request_.curves.size(); ++i) {
      std::vector<double> data_range = std::move(result_.curves[i].data_range);
      result_.curves[i] =
          fitted_curve(request_.curves[i], titles, best_.x, certainty.covariance, certainty.quantile);
      result_.curves[i].data_range = std::move(data_range);
    }
    describe_free_directions(certainty, titles);
  }

  void describe_free_directions(const Certainty& certainty, const std::vector<std::string>& titles) {
    const bool known = known_at_start(certainty);
    for (const Eigen::VectorXd& direction : certainty.free_directions) {
      std::string text = in_words(direction, titles, known, best_.x);
      if (known)
        leave_astray(std::move(text));
      else
        result_.findings.push_back(std::move(text));
    }
  }

  FittedNumber number(std::size_t unknown) {
    const Unknown& which = residuals_.unknowns()[unknown];
    const FitParameter& parameter = request_.parameters[which.parameter];
    FittedNumber one{.name = parameter.name, .record = which.record ? runs_.label(*which.record) : ""};
    one.value = best_.x[static_cast<Eigen::Index>(unknown)];
    one.start = parameter.start;
    one.dimension = parameter.dimension;
    one.unit = parameter.unit;
    one.standard_error = one.classical_error = one.serial_error = one.low = one.high =
        std::numeric_limits<double>::quiet_NaN();
    const double near = 1e-6 * (parameter.bounded() ? parameter.upper - parameter.lower : parameter.scale);
    one.at_bound = one.value - parameter.lower <= near || parameter.upper - one.value <= near;
    if (one.at_bound)
      result_.findings.push_back(fmt::format(
          "{} is at its {} bound: a value beyond it (wider bounds) or one elsewhere (`starts: 8`) "
          "may fit better",
          one.title(), one.value - parameter.lower <= near ? "lower" : "upper"));
    return one;
  }

  void set_parameters() {
    for (std::size_t record = 0; record < runs_.records(); ++record) {
      std::vector<diagram::Setting> own;
      const std::vector<diagram::Setting> all =
          settings_of(request_.parameters, residuals_.values(record, best_.x));
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (request_.parameters[j].each_record) own.push_back(all[j]);
        if (!request_.parameters[j].each_record && record == 0) result_.shared.push_back(all[j]);
      }
      result_.of_records.push_back(std::move(own));
    }
  }

  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const ModelSource& source_;
  const FitRequest& request_;
  const FitOptions& options_;
  ModelRuns runs_;
  Residuals residuals_;
  KnownPoint start_;
  Minimum best_;
  KnownPoint end_;  ///< The best point with central differences.
  FitResult result_;
};

constexpr double most_errors = 100.0;      // standard errors of a value
constexpr double least_agreement = 0.005;  // percent: printed as 0.00

void doubt_number(const FittedNumber& one, std::vector<std::string>& doubts) {
  if (one.at_bound || !(one.standard_error > most_errors * std::abs(one.value))) return;
  doubts.push_back(
      fmt::format("the standard error of {}, {:.2g}, is more than a hundred times its value, {:.2g}, so that "
                  "the records do "
                  "not decide it there; {}",
                  one.title(), one.standard_error, one.value, elsewhere));
}

void doubt_record(const FittedRecord& record, bool sought, std::vector<std::string>& doubts) {
  for (const ComparedRows& rows : record.comparisons) {
    if (!(rows.agreement < least_agreement)) continue;
    const std::string name = record.label.empty() ? "the record" : "the record " + record.label;
    doubts.push_back(fmt::format("{} is {} no better than by its mean (agreement {:.3g} %){}", name,
                                 record.held_out || !sought ? "predicted" : "described", rows.agreement,
                                 record.held_out || !sought ? "" : fmt::format("; {}", elsewhere)));
  }
}

void doubt_rows(const FitResult& result, std::vector<std::string>& doubts) {
  if (result.together == 0 || result.standard_errors == StandardErrors::serial) return;
  doubts.push_back(
      fmt::format("residuals go together over {} rows, and the standard errors count each row; where rows "
                  "follow each other "
                  "in time, 'standard_errors: serial' allows for it",
                  result.together));
}

}  // namespace

std::string FittedNumber::title() const {
  return record.empty() ? name : fmt::format("{} of {}", name, record);
}

FitResult fit(const ModelSource& source, const run::Job& job, const FitRequest& request,
              const FitOptions& options) {
  try {
    return Fit(source, job, request, options).result();
  } catch (const yaml::Error&) {  // an interrupted run has no rows to compare
    if (!source.interrupt || !*source.interrupt) throw;
    FitResult nothing;
    nothing.interrupted = true;
    return nothing;
  }
}

std::vector<std::string> doubts_of(const FitResult& result) {
  std::vector<std::string> doubts;
  for (const FittedNumber& one : result.numbers) doubt_number(one, doubts);
  for (const FittedRecord& record : result.records) doubt_record(record, !result.numbers.empty(), doubts);
  doubt_rows(result, doubts);
  return doubts;
}

}  // namespace stepwire::estimation
