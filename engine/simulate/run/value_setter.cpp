#include "engine/simulate/run/value_setter.hpp"

#include <algorithm>

namespace stepwire::run {

const Value& ValueSetter::parameter(std::size_t index) const {
  const Value* set = parameters_ ? parameters_->value(index) : nullptr;
  return set ? *set : plan_.diagram.parameters[index].value;
}

void ValueSetter::put_values(diagram::Diagram& diagram) const {
  for (const auto& [index, written] : written_) {
    const BlockType& type = written.type();
    AnyBlock& block = diagram.blocks[index].block;
    type.destroy(block.get());
    type.copy(block.get(), blocks_.memory(index));
  }
  blocks_.put_numbers(diagram);
}

std::optional<std::vector<std::size_t>> ValueSetter::set(const diagram::Variation& variation,
                                                         std::span<const diagram::Assignment> values) {
  if (variation.structural()) {
    const auto found = std::ranges::find_if(variation.names(), &diagram::Variation::Name::structural);
    structure_change_ = found->text + ": the diagram's times, records or parts follow from it";
    return std::nullopt;
  }
  if (!parameters_) parameters_.emplace(plan_.diagram);
  const std::vector<diagram::ChangedValue> changed = parameters_->set(variation, values);
  try {
    plan::PlanChange change = plan::change_of(plan_, changed, written_);
    structure_change_ = change.structure;
    if (structure_change_.empty()) return apply(change);
  } catch (...) {
    parameters_->undo();
    throw;
  }
  parameters_->undo();
  return std::nullopt;
}

std::vector<std::size_t> ValueSetter::apply(plan::PlanChange& change) {
  blocks_.apply(change);
  std::vector<std::size_t> rebuilt;
  for (plan::RebuiltBlock& block : change.blocks) {
    rebuilt.push_back(block.block);
    written_.insert_or_assign(block.block, std::move(block.written));
  }
  return rebuilt;
}

}  // namespace stepwire::run
