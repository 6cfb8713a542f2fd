#pragma once

#include "engine/analyse/study/experiment.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::study {

/// The experiments of a request as items, which hang on no other: each person of the first one with all
/// trials, of which tables are drawn, and each other experiment as the numbers that came out of it.
class StudyItems {
 public:
  /// All must outlive it.
  StudyItems(TrialRuns& runs, const StudyRequest& request, const run::Job& job)
      : runs_(runs), request_(request), job_(job), people_(people_of(request, job)) {}

  /// Does an item for another process. Throws Error.
  std::string work(const messages::Item& item) const;

  /// Has other processes perform the experiments of these seeds, of which the first is the request's. `done`
  /// is given what came out of each other one at all points of the sweep. Throws Error.
  using Done = std::function<void(std::uint64_t seed, const std::vector<std::vector<NamedValue>>& outcomes)>;
  Experiments perform_by(messages::ItemWorkers& workers, const std::vector<std::uint64_t>& seeds,
                         const Done& done) const;

 private:
  std::string person(std::size_t number) const;
  std::string experiment(std::uint64_t seed) const;
  std::vector<TrialRun> person_of_bytes(std::string_view bytes) const;
  std::vector<std::vector<NamedValue>> outcomes_of(std::string_view bytes) const;

  TrialRuns& runs_;
  const StudyRequest& request_;
  const run::Job& job_;
  const std::size_t people_;
};

}  // namespace stepwire::study
