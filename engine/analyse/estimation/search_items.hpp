#pragma once

#include <vector>

#include "engine/analyse/estimation/least_squares.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::estimation {

/// A search of a fit: its start and its limit of steps.
struct SearchStart {
  std::size_t number = 0;  ///< Index of the search within the fit.
  Eigen::VectorXd from;
  std::size_t iterations = 0;
};

/// Distributes the searches from these starts to other processes.
std::vector<Minimum> search_by(messages::ItemWorkers& workers, const std::vector<SearchStart>& starts);

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

}  // namespace stepwire::estimation
