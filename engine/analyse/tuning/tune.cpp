#include "engine/analyse/tuning/tune.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include "engine/analyse/tuning/constraint.hpp"
#include "engine/analyse/tuning/search.hpp"
#include "engine/analyse/tuning/search_items.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::tuning {
namespace {

constexpr double seen = 1.0;        // Least singular value of a direction that moves the targets.
constexpr double least_part = 0.1;  // Least component of a parameter that takes part in a direction.
constexpr double of_normal = 1.96;  // Half a 95 % interval in standard deviations.

/// Returns the 95 % interval of a parameter from the variance of its share, limited to the bounds.
std::array<double, 2> interval_of(const TuneParameter& parameter, double value, double variance) {
  const double share = parameter.share_of(value), half = of_normal * std::sqrt(variance);
  std::array<double, 2> ends{parameter.at(std::max(0.0, share - half)),
                             parameter.at(std::min(1.0, share + half))};
  std::ranges::sort(ends);
  return ends;
}

/// Returns the names of the parameters that take part in a direction.
std::string free_direction(const Eigen::VectorXd& direction, const TuneRequest& request) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const double sign = direction[largest] < 0.0 ? -1.0 : 1.0;
  std::string text;
  for (std::size_t i = 0; i < request.parameters.size(); ++i) {
    const double part = sign * direction[static_cast<Eigen::Index>(i)];
    if (std::abs(part) >= least_part)
      text += fmt::format("{}{:+.2f} {}", text.empty() ? "" : ", ", part, request.parameters[i].name);
  }
  return fmt::format("the targets leave a direction free, by shares of the bounds: {}", text);
}

/// Adds singular values, intervals and free directions.
void decompose(const TuneRequest& request, const Values& values, Resolution& result) {
  const auto rows = static_cast<Eigen::Index>(request.targets.size());
  const auto count = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd jacobian(rows, count);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 0; k < count; ++k)
      jacobian(i, k) = result.jacobian[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count), open = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double value = k < svd.singularValues().size() ? svd.singularValues()[k] : 0.0;
    const Eigen::VectorXd direction = svd.matrixV().col(k);
    result.singular_values.push_back(value);
    if (value >= seen) {
      variance += direction.cwiseAbs2() / (value * value);
      continue;
    }
    open = open.cwiseMax(direction.cwiseAbs());
    result.findings.push_back(free_direction(direction, request));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.intervals.push_back(
        open[k] >= least_part ? std::nullopt
                              : std::optional(interval_of(request.parameters[i], values[i], variance[k])));
  }
}

const char* name_of(TuneMethod method) {
  constexpr std::array names{"auto", "bobyqa", "cobyla", "isres", "subplex", "least_squares"};
  return names[static_cast<std::size_t>(method)];
}

/// Reports the progress of all searches together.
class Watch {
 public:
  Watch(const TuneOptions& options, const TuneRequest& request) : options_(options), request_(request) {}

  void show(const Evaluation& one) {
    const std::lock_guard lock(mutex_);
    ++count_;
    if (one.is_feasible() && !(one.objective >= best_)) best_ = one.objective;
    if (!options_.progress) return;
    const double all = static_cast<double>(request_.evaluations * request_.starts);
    options_.progress(std::min(1.0, static_cast<double>(count_) / all),
                      std::isnan(best_) ? fmt::format("evaluation {}", count_)
                                        : fmt::format("evaluation {}: best {:.5g}", count_, best_));
  }

 private:
  const TuneOptions& options_;
  const TuneRequest& request_;
  std::mutex mutex_;
  std::size_t count_ = 0;
  double best_ = std::numeric_limits<double>::quiet_NaN();
};

/// Computes these from central differences over a tenth of the bounds on each side, or up to the bounds.
Resolution resolution_of(const TuneRuns& runs, const TuneRequest& request, const Values& values,
                         unsigned threads) {
  Resolution result;
  Evaluation last;
  const LookAt look = [&](const Shares& shares) -> const Evaluation& {
    Values at;
    for (std::size_t i = 0; i < shares.size(); ++i) at.push_back(request.parameters[i].at(shares[i]));
    return last = evaluate(runs, request, std::move(at), threads);
  };
  Shares shares;
  for (std::size_t i = 0; i < values.size(); ++i) shares.push_back(request.parameters[i].share_of(values[i]));
  std::size_t without = 0;
  auto jacobian = target_jacobian(look, request, shares, without);
  if (!jacobian && !runs.interrupted())
    result.findings.push_back(
        fmt::format("beside what was found {} gives nothing to compare, so that there are no intervals",
                    request.parameters[without].name));
  if (!jacobian || runs.interrupted()) return result;
  result.jacobian = std::move(*jacobian);
  decompose(request, values, result);
  return result;
}

/// The steps of an optimisation. The given start is evaluated first; its values are the scales of objective
/// and claims. Searches from all starts then run in parallel, here or in other processes. If none satisfies
/// all claims, restore() minimises the largest violation from the best point, and a further search follows
/// from a point that it finds. The best evaluation of all searches is the result.
class Tuning {
 public:
  Tuning(const TuneSource& source, const run::Job& job, const TuneRequest& request,
         const TuneOptions& options)
      : request_(request), options_(options), runs_(source, job, request), watch_(options, request) {}

  TuneResult result() {
    look_at_start();
    if (!request_.parameters.empty() && !runs_.interrupted()) search_all();
    result_.interrupted = runs_.interrupted();
    choose();
    if (!best_ && !result_.interrupted) refuse();
    result_.compiled = runs_.compiled();
    result_.runs = runs_.count();
    result_.method = name_of(request_.chosen_method());
    result_.dimension = request_.objective_dimension();
    result_.bad = static_cast<std::size_t>(std::ranges::count_if(result_.history, &Evaluation::is_bad));
    if (best_) describe();
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    return std::move(result_);
  }

 private:
  unsigned threads() const { return runs_.pool().threads(options_.threads); }

  /// Evaluates the start; its values are the scales of objective and claims.
  void look_at_start() {
    Evaluation one = evaluate(runs_, request_, start_of(request_.parameters), threads());
    if (runs_.interrupted()) return;
    problem_.objective_scale = one.is_bad() || one.objective == 0.0 ? 1.0 : std::abs(one.objective);
    for (std::size_t i = 0; i < request_.constraints.size(); ++i)
      problem_.claim_scales.push_back(scale_of(request_.constraints[i].comparison, one.claims[i]));
    result_.start_objective = one.objective;
    watch_.show(one);
    start_ = std::move(one);
  }

  void search_all() {
    std::vector<SearchResult> found =
        options_.workers ? search_by(*options_.workers, problem_, start_) : search_here();
    for (SearchResult& one : found) take(std::move(one));
    if (!choose()) restore_claims();
  }

  std::vector<SearchResult> search_here() {
    const std::size_t count = request_.starts;
    const auto beside = static_cast<unsigned>(std::min<std::size_t>(threads(), count));
    problem_.threads = std::max(1u, threads() / beside);
    problem_.watch = [&](const Evaluation& one) { watch_.show(one); };
    std::vector<SearchResult> found(count);
    runs_.pool().in_parallel(count, beside, [&](std::size_t i) {
      if (runs_.interrupted() && i > 0) return;
      found[i] = search(problem_, i, i == 0 ? start_ : std::nullopt);
    });
    return found;
  }

  void take(SearchResult&& one) {
    TunedStart& start = result_.starts.emplace_back();
    if (one.best) start.objective = one.evaluations[*one.best].objective;
    start.converged = one.converged;
    start.evaluations = one.evaluations.size();
    std::ranges::move(one.evaluations, std::back_inserter(result_.history));
  }

  [[noreturn]] void refuse() const {
    throw yaml::Error(yaml::Fault{
        request_.place,
        "tune",
        fmt::format("no start can be evaluated; give one that runs: {}", result_.history.front().fault),
        {}});
  }

  /// Searches for the point with the smallest violation if no search satisfied all claims.
  void restore_claims() {
    if (runs_.interrupted() || !nearest()) return;
    problem_.threads = threads();
    SearchResult found = restore(problem_, result_.history[*nearest()].values);
    std::ranges::move(found.evaluations, std::back_inserter(result_.history));
    if (const auto best = choose()) take(search(problem_, 0, Evaluation(result_.history[*best])));
  }

  /// Selects the best point that satisfies all claims, the first of equal ones; else the nearest().
  std::optional<std::size_t> choose() {
    if (result_.history.empty() && start_) result_.history.push_back(*start_);
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < result_.history.size(); ++i) {
      const Evaluation& one = result_.history[i];
      if (one.is_feasible() && (!found || one.objective < result_.history[*found].objective)) found = i;
    }
    result_.feasible = found.has_value();
    best_ = found ? found : nearest();
    return found;
  }

  /// Returns the index of the evaluation with the smallest violation.
  std::optional<std::size_t> nearest() const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < result_.history.size(); ++i)
      if (!result_.history[i].is_bad() && (!found || violation_of(result_.history[i], problem_) <
                                                         violation_of(result_.history[*found], problem_)))
        found = i;
    return found;
  }

  void describe() {
    const Evaluation& best = result_.history[*best_];
    result_.objective = best.objective;
    if (runs_.count() > 1 && request_.over == TuneOver::worst) result_.worst = runs_.label(best.worst);
    result_.converged =
        request_.parameters.empty() || std::ranges::any_of(result_.starts, [&](const TunedStart& start) {
          return start.converged && start.objective && *start.objective <= best.objective;
        });
    result_.settings = settings_of(request_.parameters, best.values);
    for (std::size_t i = 0; i < request_.parameters.size(); ++i)
      describe(request_.parameters[i], best.values[i]);
    describe_claims(best);
    if (!request_.targets.empty() && !result_.interrupted) resolve(best);
    note_bad();
  }

  /// Adds singular values and intervals.
  void resolve(const Evaluation& best) {
    result_.resolution = resolution_of(runs_, request_, best.values, threads());
    result_.interrupted = runs_.interrupted();
    const Resolution& found = result_.resolution;
    for (std::size_t i = 0; i < found.intervals.size(); ++i) result_.numbers[i].interval = found.intervals[i];
    for (const std::string& finding : found.findings) result_.findings.push_back(finding);
  }

  void describe(const TuneParameter& parameter, double value) {
    TunedNumber one{.name = parameter.name,
                    .value = value,
                    .start = parameter.start,
                    .lower = parameter.lower,
                    .upper = parameter.upper,
                    .dimension = parameter.dimension,
                    .unit = parameter.unit};
    const double share = parameter.share_of(value);
    one.at_bound = share <= request_.tolerance || share >= 1.0 - request_.tolerance;
    if (one.at_bound && result_.feasible)
      result_.findings.push_back(
          fmt::format("{} is at its {} end, beyond which the objective may fall further", one.name,
                      share < 0.5 ? "lower" : "upper"));
    result_.numbers.push_back(std::move(one));
  }

  void describe_claims(const Evaluation& best) {
    if (request_.claims().empty() || runs_.interrupted()) return;
    std::string fault;
    const std::vector<record::Recording> recordings = runs_.run(best.values, threads(), fault);
    for (std::size_t i = 0; i < request_.targets.size() && fault.empty(); ++i)
      result_.targets.push_back({claim::judge(request_.targets[i], recordings), best.offs[i],
                                 start_ && !start_->offs.empty() ? start_->offs[i] : best.offs[i]});
    for (std::size_t i = 0; i < request_.constraints.size(); ++i) {
      TunedClaim one{claim::judge(request_.constraints[i], recordings), best.margins[i],
                     start_ ? start_->claims[i] : best.claims[i]};
      if (one.verdict.run) one.verdict.shown += fmt::format(" ({})", runs_.label(*one.verdict.run));
      one.active = best.margins[i] < 10.0 * request_.tolerance * problem_.claim_scales[i];
      if (!one.verdict.holds)
        result_.findings.push_back(fmt::format("'{}' is in the way: nowhere nearer than {}, {}",
                                               one.verdict.that, one.verdict.shown, one.verdict.check));
      result_.claims.push_back(std::move(one));
    }
  }

  void note_bad() {
    const auto first = std::ranges::find_if(result_.history, &Evaluation::is_bad);
    if (first == result_.history.end()) return;
    result_.findings.push_back(fmt::format("{} of {} gave nothing to compare, the first since {}",
                                           result_.bad, text::counted(result_.history.size(), "evaluation"),
                                           first->fault));
  }

  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const TuneRequest& request_;
  const TuneOptions& options_;
  TuneRuns runs_;
  Watch watch_;
  SearchProblem problem_{.runs = runs_, .request = request_};
  std::optional<Evaluation> start_;
  std::optional<std::size_t> best_;
  TuneResult result_;
};

}  // namespace

TuneResult tune(const TuneSource& source, const run::Job& job, const TuneRequest& request,
                const TuneOptions& options) {
  return Tuning(source, job, request, options).result();
}

}  // namespace stepwire::tuning
