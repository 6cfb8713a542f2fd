#pragma once

#include "engine/analyse/tuning/search.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::tuning {

/// Distributes the searches of a problem to other processes; `start` is the evaluation of the given start.
std::vector<SearchResult> search_by(messages::ItemWorkers& workers, const SearchProblem& problem,
                                    const std::optional<Evaluation>& start);

/// Worker for the search_by() of another process; its results have the same bits.
class SearchWork {
 public:
  /// Job and request must outlive it. Throws Error.
  SearchWork(const TuneSource& source, const run::Job& job, const TuneRequest& request, unsigned threads)
      : request_(request), threads_(threads), runs_(source, job, request) {}
  std::string work(const messages::Item& item) const;

 private:
  const TuneRequest& request_;
  const unsigned threads_;
  TuneRuns runs_;
};

}  // namespace stepwire::tuning
