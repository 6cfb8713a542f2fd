#include "engine/analyse/tuning/search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <random>

#include "engine/analyse/estimation/bounded_squares.hpp"
#include "engine/analyse/tuning/constraint.hpp"

namespace stepwire::tuning {
namespace {

/// Evaluations of a search, and their numbers in the form that NLopt takes.
class SearchLog {
 public:
  explicit SearchLog(const SearchProblem& problem) : problem_(problem) {}

  std::size_t size() const { return evaluations_.size(); }
  const Evaluation& operator[](std::size_t i) const { return evaluations_[i]; }
  const Evaluation& add(const Shares& shares, Evaluation evaluation);
  /// Returns the index of a point among the last 16. NLopt reads objective and claims of a point in separate
  /// calls.
  std::optional<std::size_t> find(const Shares& shares) const;

  /// Returns the index of the least objective with all claims satisfied, the first of equal ones.
  std::optional<std::size_t> best() const;
  /// Returns the best point, or the one with the smallest violation.
  std::optional<Shares> best_known() const;
  /// Returns the best objective over the objective's scale; infinite if no point satisfies all claims.
  double merit() const;

  /// Returns the objective over its scale. A point that cannot be run is worse than all points so far.
  double objective_of(const Evaluation& evaluation) const;
  /// Returns the violation of each bound of each claim over its scale, plus a small reserve. The reserve
  /// ensures that a solution on the bound passes the claim's own check.
  std::vector<double> sides_of(const Evaluation& evaluation) const;

  std::vector<Evaluation> take() { return std::move(evaluations_); }

 private:
  const SearchProblem& problem_;
  std::vector<Shares> points_;
  std::vector<Evaluation> evaluations_;
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

constexpr double farthest = 2.0;  // violation of a claim without a value

/// Limits a violation to the range from -2 to 2: identity below 1, then 2 - 1 / size. An infinite margin
/// would break the linear models of COBYLA.
double bounded(double violation) {
  if (std::isnan(violation)) return farthest;
  const double size = std::abs(violation);
  return size <= 1.0 ? violation : std::copysign(farthest - 1.0 / size, violation);
}

constexpr double step = 0.1;  // share of the way between the bounds, on each side

constexpr double first_step = 0.1;    // Share of the range of a parameter.
constexpr double global_share = 0.8;  // Share of the evaluations for isres; the rest start at its best point.
constexpr std::size_t attempts = 20;  // Random starts to try until one runs.
constexpr std::size_t max_rounds = 4;      // Rounds of cobyla, whose steps only shrink.
constexpr double below_the_claims = 0.01;  // Reserve by which restore() satisfies a claim.
constexpr double highest_violation = 2.0;

/// Returns uniform random shares of the bounds, 0 to 1. They depend on the arguments only and are the same on
/// any machine.
std::vector<double> random_shares(std::uint64_t seed, std::size_t number, std::size_t count,
                                  std::size_t attempt) {
  std::seed_seq words{seed, static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(attempt)};
  std::mt19937_64 engine(words);
  std::vector<double> shares(count);
  for (double& share : shares) share = static_cast<double>(engine() >> 11u) * 0x1p-53;
  return shares;
}

/// Minimises the squared errors of the targets by the Levenberg-Marquardt method within the bounds. Its
/// derivatives are those of target_jacobian(): wide differences average out the scatter of experiments.
/// Returns true if converged.
bool search_targets(const LookAt& look, const TuneRequest& request, const Shares& from) {
  estimation::BoundedSquares squares{
      .residuals = request.targets.size(), .iterations = request.evaluations, .tolerance = request.tolerance};
  squares.evaluate = [&](const Shares& at, double* residuals, double* jacobian) {
    const Evaluation& one = look(at);
    if (one.is_bad()) return false;
    std::ranges::copy(one.offs, residuals);
    if (!jacobian) return true;
    std::size_t without = 0;
    const auto rows = target_jacobian(look, request, at, without);
    if (!rows) return false;
    for (const std::vector<double>& row : *rows) jacobian = std::ranges::copy(row, jacobian).out;
    return true;
  };
  return estimation::minimise_squares(squares, from);
}

/// One search: its log of evaluations and the callbacks of NLopt.
/// NLopt minimises over the shares of the parameters between their bounds. Objective and claims are divided
/// by their scales at the start, so that one tolerance fits all. A point is evaluated once, although NLopt
/// reads its objective and its claims in separate calls. A failed run has a finite, bad objective, so that
/// the search continues. COBYLA (Powell 1994) handles the claims as inequalities without derivatives. Its
/// steps only shrink, so it is restarted at its best point until a round gains less than the tolerance. ISRES
/// uses the first 80 % of the evaluations for a global search, and COBYLA refines its best point. The cost is
/// the number of evaluations; limit_ ends the search by nlopt::forced_stop.
class Search {
 public:
  Search(const SearchProblem& problem, std::size_t number)
      : problem_(problem), number_(number), log_(problem) {}

  void know(const Evaluation& evaluation) { log_.add(shares_of(evaluation.values), evaluation); }

  SearchResult result() {
    const auto best = log_.best();
    return {log_.take(), best, converged_};
  }

  /// Searches from the given start, or from the first of several random ones that can be run.
  void go() {
    std::optional<Shares> start = begin();
    if (request().chosen_method() == TuneMethod::isres) {
      const double share = global_share * static_cast<double>(request().evaluations);
      minimise(nlopt::GN_ISRES, start.value_or(Shares(size(), 0.5)), static_cast<std::size_t>(share),
               first_step);
      start = log_.best_known();
    }
    if (start) descend(*start);
  }

  /// Minimises the largest violation of the claims. It is an additional variable t, and each violation is
  /// constrained to at most t.
  void restore(const Values& from) {
    Shares x = shares_of(from);
    const std::vector<double> sides = log_.sides_of(look(x));
    x.push_back(std::min(highest_violation, *std::ranges::max_element(sides)));
    std::vector<double> low(size(), 0.0), high(size(), 1.0);
    low.push_back(-below_the_claims);
    high.push_back(highest_violation);
    nlopt::opt method(nlopt::LN_COBYLA, static_cast<unsigned>(size() + 1));
    method.set_lower_bounds(low);
    method.set_upper_bounds(high);
    method.set_min_objective([](unsigned n, const double* at, double*, void*) { return at[n - 1]; }, nullptr);
    add_claims(method, [](unsigned m, double* result, unsigned n, const double* at, double*, void* self) {
      static_cast<Search*>(self)->claims_at(m, result, Shares(at, at + n - 1), at[n - 1]);
    });
    run(method, x, first_step, request().evaluations);
  }

 private:
  const TuneRequest& request() const { return problem_.request; }
  std::size_t size() const { return request().parameters.size(); }

  Shares shares_of(const Values& values) const {
    Shares shares;
    for (std::size_t i = 0; i < size(); ++i) shares.push_back(request().parameters[i].share_of(values[i]));
    return shares;
  }

  Values values_of(const Shares& shares) const {
    Values values;
    for (std::size_t i = 0; i < size(); ++i) values.push_back(request().parameters[i].at(shares[i]));
    return values;
  }

  /// Returns the start of the search; std::nullopt if it cannot be run.
  std::optional<Shares> begin() {
    if (number_ == 0)
      return log_.size() == 0 || log_[0].is_bad() ? std::nullopt : std::optional(shares_of(log_[0].values));
    for (std::size_t attempt = 0; attempt < attempts && may_go_on(); ++attempt) {
      Shares shares = random_shares(request().seed, number_, size(), attempt);
      if (!look(shares).is_bad()) return shares;
    }
    return std::nullopt;
  }

  bool may_go_on() const { return !problem_.runs.interrupted() && log_.size() < request().evaluations; }

  void descend(Shares from) {
    const TuneMethod method = request().chosen_method();
    if (method == TuneMethod::bobyqa)
      return minimise(nlopt::LN_BOBYQA, from, request().evaluations, first_step);
    if (method == TuneMethod::subplex)
      return minimise(nlopt::LN_SBPLX, from, request().evaluations, first_step);
    if (method == TuneMethod::least_squares) return descend_on_targets(from);
    double step = first_step;
    for (std::size_t round = 0; round < max_rounds && may_go_on(); ++round) {
      const double before = log_.merit();
      minimise(nlopt::LN_COBYLA, from, request().evaluations, step);
      if (!converged_ || !(log_.merit() < before - request().tolerance)) return;
      from = log_.best_known().value_or(from);
      step = std::max(0.3 * step, 10.0 * request().tolerance);
    }
  }

  void descend_on_targets(const Shares& from) {
    limit_ = request().evaluations;
    converged_ = false;
    try {
      converged_ = search_targets([this](const Shares& at) -> const Evaluation& { return looked_at(at); },
                                  request(), from);
    } catch (const nlopt::forced_stop&) {  // evaluations used up, or interrupted
    }
    if (thrown_) std::rethrow_exception(thrown_);
  }

  void minimise(nlopt::algorithm algorithm, Shares from, std::size_t most, double step) {
    nlopt::opt method(algorithm, static_cast<unsigned>(size()));
    method.set_lower_bounds(0.0);
    method.set_upper_bounds(1.0);
    method.set_min_objective(
        [](unsigned n, const double* at, double*, void* self) {
          auto* search = static_cast<Search*>(self);
          return search->log_.objective_of(search->looked_at(Shares(at, at + n)));
        },
        this);
    add_claims(method, [](unsigned m, double* result, unsigned n, const double* at, double*, void* self) {
      static_cast<Search*>(self)->claims_at(m, result, Shares(at, at + n), 0.0);
    });
    run(method, from, step, most);
  }

  void add_claims(nlopt::opt& method, nlopt::mfunc claims) {
    if (log_.size() == 0) look(Shares(size(), 0.5));
    const std::size_t sides = log_.sides_of(log_[0]).size();
    if (sides > 0) method.add_inequality_mconstraint(claims, this, std::vector<double>(sides, 0.0));
  }

  void run(nlopt::opt& method, Shares& x, double step, std::size_t most) {
    if (log_.size() >= most || problem_.runs.interrupted()) return;
    limit_ = most;
    method.set_initial_step(step);
    method.set_xtol_abs(request().tolerance);
    method.set_maxeval(static_cast<int>(std::min<std::size_t>(10 * most, 2'000'000'000)));
    nlopt::srand(static_cast<unsigned long>(request().seed + number_));  // per thread
    double value = 0.0;
    converged_ = false;
    try {
      const nlopt::result why = method.optimize(x, value);
      converged_ = why == nlopt::XTOL_REACHED || why == nlopt::FTOL_REACHED || why == nlopt::SUCCESS;
    } catch (const nlopt::forced_stop&) {  // evaluations used up, or interrupted
    } catch (const nlopt::roundoff_limited&) {
      converged_ = true;
    }
    if (thrown_) std::rethrow_exception(thrown_);
  }

  const Evaluation& look(const Shares& shares) {
    if (const auto known = log_.find(shares)) return log_[*known];
    Evaluation one = evaluate(problem_.runs, request(), values_of(shares), problem_.threads);
    one.start = number_;
    if (problem_.runs.interrupted()) throw nlopt::forced_stop();
    if (problem_.watch) problem_.watch(one);
    return log_.add(shares, std::move(one));
  }

  /// Evaluates a point within a call of NLopt, where only nlopt::forced_stop may be thrown; others are
  /// stored in thrown_.
  const Evaluation& looked_at(const Shares& shares) {
    try {
      if (!log_.find(shares) && log_.size() >= limit_) throw nlopt::forced_stop();
      return look(shares);
    } catch (const nlopt::forced_stop&) {
      throw;
    } catch (...) {
      thrown_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  void claims_at(unsigned count, double* result, const Shares& shares, double allowed) {
    const std::vector<double> sides = log_.sides_of(looked_at(shares));
    for (unsigned i = 0; i < count; ++i) result[i] = sides[i] - allowed;
  }

  const SearchProblem& problem_;
  const std::size_t number_;
  SearchLog log_;
  std::size_t limit_ = 0;
  bool converged_ = false;
  std::exception_ptr thrown_;
};

const Evaluation& SearchLog::add(const Shares& shares, Evaluation evaluation) {
  if (!evaluation.is_bad()) {
    const double scaled = evaluation.objective / problem_.objective_scale;
    least_ = std::min(least_, scaled);
    most_ = std::max(most_, scaled);
  }
  points_.push_back(shares);
  evaluations_.push_back(std::move(evaluation));
  return evaluations_.back();
}

std::optional<std::size_t> SearchLog::find(const Shares& shares) const {
  constexpr std::size_t looks = 16;
  for (std::size_t i = size(); i-- > size() - std::min(looks, size());)
    if (points_[i] == shares) return i;
  return std::nullopt;
}

std::optional<std::size_t> SearchLog::best() const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < size(); ++i)
    if (evaluations_[i].is_feasible() &&
        (!found || evaluations_[i].objective < evaluations_[*found].objective))
      found = i;
  return found;
}

std::optional<Shares> SearchLog::best_known() const {
  if (const auto found = best()) return points_[*found];
  std::optional<std::size_t> found;
  double nearest = farthest;
  for (std::size_t i = 0; i < size(); ++i) {
    const double away = violation_of(evaluations_[i], problem_);
    if (evaluations_[i].is_bad() || (found && away >= nearest)) continue;
    nearest = away;
    found = i;
  }
  return found ? std::optional(points_[*found]) : std::nullopt;
}

double SearchLog::merit() const {
  const auto found = best();
  return found ? evaluations_[*found].objective / problem_.objective_scale
               : std::numeric_limits<double>::infinity();
}

double SearchLog::objective_of(const Evaluation& evaluation) const {
  if (!evaluation.is_bad()) return evaluation.objective / problem_.objective_scale;
  return most_ < least_ ? 1.0 : most_ + std::max(1.0, most_ - least_);
}

std::vector<double> SearchLog::sides_of(const Evaluation& evaluation) const {
  std::vector<double> all;
  const auto& constraints = problem_.request.constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const double scale = problem_.claim_scales[i];
    const double spare =
        std::min(problem_.request.tolerance, 0.05 * room_of(constraints[i].comparison) / scale);
    for (const double margin : tuning::sides_of(constraints[i].comparison, evaluation.claims[i]))
      all.push_back(bounded(-margin / scale + spare));
  }
  return all;
}

}  // namespace

double violation_of(const Evaluation& evaluation, const SearchProblem& problem) {
  double most = evaluation.is_bad() ? farthest : 0.0;
  for (std::size_t i = 0; i < evaluation.margins.size(); ++i)
    most = std::max(most, bounded(-evaluation.margins[i] / problem.claim_scales[i]));
  return most;
}

std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without) {
  std::vector<std::vector<double>> rows(request.targets.size());
  for (without = 0; without < at.size(); ++without) {
    Shares low = at, high = at;
    low[without] = std::max(0.0, at[without] - step);
    high[without] = std::min(1.0, at[without] + step);
    const Evaluation below = look(low), above = look(high);  // copies: look() may move the first one
    if (below.is_bad() || above.is_bad()) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].push_back((above.offs[i] - below.offs[i]) / (high[without] - low[without]));
  }
  return rows;
}

SearchResult search(const SearchProblem& problem, std::size_t number,
                    const std::optional<Evaluation>& known) {
  Search one(problem, number);
  if (known) one.know(*known);
  try {
    one.go();
  } catch (const nlopt::forced_stop&) {  // interrupted at its start
  }
  return one.result();
}

SearchResult restore(const SearchProblem& problem, const Values& from) {
  Search one(problem, problem.request.starts);
  try {
    one.restore(from);
  } catch (const nlopt::forced_stop&) {  // interrupted
  }
  return one.result();
}

}  // namespace stepwire::tuning
