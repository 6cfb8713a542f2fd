#include "engine/app/session/findings.hpp"

#include "engine/view/plot/empty_selection.hpp"

namespace stepwire::session {

std::vector<std::string> findings_of(const LoadedModel& model, const Outcome& outcome) {
  if (outcome.early()) return {};
  return plot::empty_selections(model.figures, outcome.recordings());
}

}  // namespace stepwire::session
