#include "engine/simulate/codegen/start_text.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/external_input.hpp"
#include "engine/simulate/codegen/literals.hpp"

namespace stepwire::codegen {

std::string StartText::constants() const {
  std::string text;
  for (std::size_t i = 0; i < plan_.constants.size(); ++i)
    text += fmt::format("  w[{}] = {};\n", plan_.layout.constants + i,
                        number_at(plan_.layout.constants + i, plan_.constants[i]));
  return text;
}

std::vector<Code> StartText::initial() const {
  std::vector<Code> code;
  for (const int block : plan_.memory_order) add_initial(static_cast<std::size_t>(block), code);
  return code;
}

/// Returns a number as a literal, or the table entry that it is read from.
std::string StartText::number_at(std::size_t place, double number) const {
  const auto found = places_.find(place);
  return found == places_.end() ? number_text(number) : fmt::format("numbers[{}]", found->second);
}

void StartText::add_initial(std::size_t b, std::vector<Code>& code) const {
  const diagram::DiagramBlock& block = plan_.diagram.blocks[b];
  const plan::PlannedBlock& planned = plan_.blocks[b];
  const auto assign = [&](const plan::SignalSlot& slot, bool always, const auto& value) {
    std::string text;
    for (Index k = 0; k < slot.size; ++k)
      if (const std::string number = number_at(slot.offset + static_cast<std::size_t>(k), value(k));
          always || number != "0.0")
        text += fmt::format("  w[{} + {}] = {};\n", names_.at(slot.offset), k, number);
    if (!text.empty()) code.push_back({std::move(text)});
  };
  for (std::size_t s = 0; s < planned.states.size(); ++s)
    assign(planned.states[s], false, [&](Index) { return block.type().states[s].initial; });
  for (const diagram::InitialValue& initial : block.initial)
    assign(planned.states[static_cast<std::size_t>(initial.state)], true,
           [&](Index k) { return initial.value[initial.value.size() == 1 ? 0 : k]; });
  if (&block.type() == &diagram::external_input_type()) {
    const PerElement& value = static_cast<const diagram::ExternalInput*>(block.block.get())->value;
    assign(planned.outputs.front(), false, [&](Index k) { return value[k]; });
  }
}

}  // namespace stepwire::codegen
