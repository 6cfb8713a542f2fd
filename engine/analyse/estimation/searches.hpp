#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <vector>

#include "engine/analyse/estimation/least_squares.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/analyse/estimation/residuals.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::estimation {

/// A search of a fit: its start and its limit of steps.
struct SearchStart {
  std::size_t number = 0;  ///< Index of the search within the fit.
  Eigen::VectorXd from;
  std::size_t iterations = 0;
};

/// Worker for the search_by() of another process; its results have the same bits.
class SearchWork {
 public:
  /// Job and request must outlive it. Throws Error.
  SearchWork(const ModelSource& source, const run::Job& job, const FitRequest& request, unsigned threads);
  std::string work(const messages::Item& item) const;

 private:
  const FitRequest& request_;
  const std::atomic<bool>* interrupt_;
  ModelRuns runs_;
  Residuals residuals_;
};

/// Returns the starts of a fit: the given one, then random ones within the bounds. They are uniform in the
/// logarithm if the bounds differ by more than a factor of ten. Without bounds they are from half to twice
/// the start. Points that the diagram refuses are drawn again. The result depends on the seed only, on any
/// machine.
std::vector<Eigen::VectorXd> make_starts(const Residuals& residuals, const FitRequest& request);

/// Callback after each generation, with its number and the best cost.
using GenerationWatcher = std::function<void(std::size_t generation, double cost)>;

/// Minimises the cost by differential evolution (rand/1/bin, factor 0.7, crossover 0.9) within the bounds and
/// the accepted values. The given start is in the first population. Returns the best point. R. Storn, K.
/// Price 1997.
Eigen::VectorXd evolve(const Residuals& residuals, const FitRequest& request,
                       const std::atomic<bool>* interrupt, const GenerationWatcher& watch);

/// Multi-start search: a few steps from each start, then full searches from the best ones.
class Searches {
 public:
  /// Function that searches from a start and reports its progress from `done` to `done + share`.
  using Descend =
      std::function<Minimum(const SearchStart& start, double done, double share, const std::string& what)>;

  /// With `workers`, unless nullptr, other processes search instead of `descend`.
  Searches(const FitRequest& request, const std::atomic<bool>* interrupt, messages::ItemWorkers* workers,
           Descend descend)
      : request_(request), interrupt_(interrupt), workers_(workers), descend_(std::move(descend)) {}

  /// Returns the end of each search; at least one after an interruption.
  std::vector<Minimum> from(const std::vector<Eigen::VectorXd>& starts) const;

 private:
  std::vector<Minimum> first_looks(const std::vector<Eigen::VectorXd>& starts) const;
  void follow(std::vector<Minimum>& minima) const;
  template <class NameOf>
  std::vector<Minimum> search(const std::vector<SearchStart>& starts, double done, double share,
                              const NameOf& name_of) const;

  const FitRequest& request_;
  const std::atomic<bool>* interrupt_;
  messages::ItemWorkers* workers_;
  Descend descend_;
};

/// Returns the indices of the minima by rising cost; equal ones remain in order.
std::vector<std::size_t> ranking(const std::vector<Minimum>& minima);

/// A minimum after refine().
struct Refined {
  Minimum minimum;
  KnownPoint at;        ///< The point with central differences; without derivatives if these fail.
  double change = 0.0;  ///< Largest part of the last step, relative to a value or its standard error.
};

/// Refines the end of a search by Gauss-Newton steps with central differences. A search that compares costs
/// ends early: a thousandth of a standard error changes the cost by 1e-6 of one row's part. Refinement ends
/// when a step changes each unknown by at most `tolerance` of the larger of its value and its standard error.
/// It also ends when steps no longer become smaller. Unknowns at a bound towards which the cost falls are
/// held there.
Refined refine(const Residuals& residuals, const FitRequest& request, Minimum found,
               const std::atomic<bool>* interrupt);

}  // namespace stepwire::estimation
