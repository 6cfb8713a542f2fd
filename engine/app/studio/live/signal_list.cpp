#include "engine/app/studio/live/signal_list.hpp"

#include "engine/model/diagram/named_signals.hpp"
#include "engine/model/plan/element_slot.hpp"

namespace stepwire::live {

SignalList::SignalList(const plan::Plan& plan) {
  for (const diagram::RecordRequest& request : plan.diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals) add(plan, signal.name, signal.signal, true);
  for (const auto& [name, signal] : diagram::named_signals(plan.diagram)) add(plan, name, signal, false);
}

void SignalList::add(const plan::Plan& plan, const std::string& name, const diagram::SignalRef& signal,
                     bool recorded) {
  const plan::SignalSlot slot = plan.slot(signal);
  for (Eigen::Index k = 0; k < slot.size; ++k) {
    std::string own = plan::element_name(name, slot, k);
    if (!index_.emplace(own, signals_.size()).second) continue;
    signals_.push_back(
        {std::move(own), plan.dimension(signal), slot.offset + static_cast<std::size_t>(k), recorded});
  }
}

std::optional<std::size_t> SignalList::find(const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

query::SymbolTable SignalList::names(const plan::Plan& plan) const {
  query::SymbolTable names;
  names.file = plan.diagram.file;
  names.unknown = "is no signal of the diagram";
  names.columns.push_back({"time", unit::parse_unit("s")->dimension, std::nullopt});
  for (const LiveSignal& signal : signals_)
    names.columns.push_back({signal.name, signal.dimension, std::nullopt});
  for (const diagram::DiagramParameter& parameter : plan.diagram.parameters)
    if (const double* number = std::get_if<double>(&parameter.value.content))
      names.parameters.push_back({parameter.name, *number, parameter.dimension});
  return names;
}

std::string unit_text(const std::optional<unit::Dimension>& dimension) {
  const bool has_unit = dimension && (*dimension != unit::Dimension{} || dimension->angle == 1.0);
  return has_unit ? unit::si_name(*dimension) : "";
}

}  // namespace stepwire::live
