#pragma once

#include "engine/analyse/study/experiment.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::study {

/// The experiments of a request as independent work items. A person of the first experiment is one item with
/// all trials, since tables and figures show them. Each further experiment is one item that returns its
/// results only.
class StudyItems {
 public:
  /// All arguments must outlive it.
  StudyItems(TrialRuns& runs, const StudyRequest& request, const run::Job& job)
      : runs_(runs), request_(request), job_(job), people_(people_of(request, job)) {}

  /// Processes an item for another process. Throws Error.
  std::string work(const messages::Item& item) const;

  /// Distributes the experiments of these seeds to other processes; the first seed is the request's. The
  /// callback receives the results of each further experiment at all points of the sweep. Throws Error.
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
