#include "engine/app/fmu/signal_names.hpp"

namespace stepwire::fmu {

std::set<std::string> signal_names(const diagram::Diagram& diagram) {
  std::set<std::string> names;
  for (const diagram::DiagramInput& input : diagram.inputs) names.insert(input.name);
  for (const diagram::DiagramOutput& output : diagram.outputs) names.insert(output.name);
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& recorded : request.signals) names.insert(recorded.name);
  return names;
}

}  // namespace stepwire::fmu
