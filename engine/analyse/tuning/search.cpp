#include "engine/analyse/tuning/search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>
#include <random>

#include "engine/analyse/tuning/search_log.hpp"
#include "engine/analyse/tuning/target_search.hpp"

namespace stepwire::tuning {

namespace {

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

}  // namespace

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
