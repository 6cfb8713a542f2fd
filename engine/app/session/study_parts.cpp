#include "engine/app/session/study_parts.hpp"

#include <fmt/format.h>

#include "engine/analyse/study/study_items.hpp"

namespace stepwire::session {

study::Experiments perform_by(messages::ItemWorkers& workers, StudyParts& parts, const LoadedModel& model,
                              const std::vector<std::uint64_t>& seeds, KeptExperiments& kept) {
  study::Experiments first = study::StudyItems(*parts.runs, *model.study, model.job)
                                 .perform_by(workers, seeds, [&](std::uint64_t seed, const auto& outcomes) {
                                   kept.add(seed, outcomes);
                                 });
  kept.add(first);
  kept.complete(first);
  return first;
}

messages::ItemWork study_work(const Registry& registry, const LoadedModel& model, const StudyCall& call) {
  const study::StudyRequest& request = *model.study;
  const auto parts = std::make_shared<StudyParts>(registry, model, call, request.experiments, Monitor{});
  const auto items = std::make_shared<study::StudyItems>(*parts->runs, request, model.job);
  return [parts, items](const messages::Item& item) { return items->work(item); };
}

std::size_t most_items(const LoadedModel& model) {
  return study::people_of(*model.study, model.job) + model.study->experiments;
}

std::string study_items_key(const LoadedModel& model) {
  return fmt::format("{} {}", experiments_note(model), model.study->seed);
}

}  // namespace stepwire::session
