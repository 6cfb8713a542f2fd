#pragma once

#include <vector>

#include "engine/analyse/estimation/least_squares.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::estimation {

/// A search of a fit: where it begins, and how many steps it takes at most.
struct SearchStart {
  std::size_t number = 0;  ///< by which a fit knows the search again
  Eigen::VectorXd from;
  std::size_t iterations = 0;
};

/// Has other processes search from these starts.
std::vector<Minimum> search_by(messages::ItemWorkers& workers, const std::vector<SearchStart>& starts);

/// Searches of the search_by() of another process, to the bits of its own.
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
