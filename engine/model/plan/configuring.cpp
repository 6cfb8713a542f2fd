#include "engine/model/plan/configuring.hpp"

#include <fmt/format.h>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

double period_of(const Plan& plan, std::size_t index) {
  return plan.time_of(plan.blocks[index].rate.ticks);
}

/// Collects the information that a block can query in configure().
Configure what_is_known(const Plan& plan, std::size_t index, std::map<std::string, double> constants) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[index];
  std::set<std::string> connected;
  std::map<std::string, Eigen::Index> counts;
  std::set<std::string> initial;
  for (std::size_t input = 0; input < block.inputs.size(); ++input) {
    const InputSpec& spec = block.type().inputs[input];
    if (!block.inputs[input].empty()) connected.insert(spec.name);
    if (block.inputs[input].size() == 1)
      if (const diagram::Source& source = block.inputs[input].front();
          source.block < 0 && source.constant.size() == 1)
        constants.try_emplace(spec.name, source.constant[0]);
    if (spec.list) counts[spec.name] = static_cast<Eigen::Index>(block.inputs[input].size());
  }
  for (const diagram::InitialValue& value : block.initial)
    initial.insert(block.type().states[static_cast<std::size_t>(value.state)].name);
  const Rate& rate = plan.blocks[index].rate;
  const bool continuous = rate.kind == Rate::Kind::continuous;
  const bool each_tick = rate.kind == Rate::Kind::discrete && rate.ticks == 1 && !block.every;
  return Configure(std::move(connected), period_of(plan, index), std::move(counts), block.name,
                   std::move(constants), std::move(initial),
                   plan.diagram.events.locate && (continuous || each_tick), continuous);
}

yaml::Fault fault_of(const Plan& plan, std::size_t index, const ParameterRefused& refused) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[index];
  const BlockType& type = block.type();
  const ParameterSpec* spec = type.parameter(refused.parameter);
  yaml::Mark mark =
      spec ? block.parameter_marks[static_cast<std::size_t>(spec - type.parameters.data())] : yaml::Mark{};
  if (const int input = type.input(refused.parameter); !spec && input >= 0)
    mark = block.input_marks[static_cast<std::size_t>(input)];
  if (refused.line > 0) mark = {refused.line, refused.column};
  if (mark.line == 0) mark = block.origin.mark;
  return plan.diagram.fault({block.origin.scope, mark}, block.name + "." + refused.parameter, refused.what());
}

}  // namespace

Configuration configure(const Plan& plan, std::size_t index, void* block, yaml::Faults& faults,
                        const std::map<std::string, double>& constants) {
  const diagram::DiagramBlock& known = plan.diagram.blocks[index];
  Configure is = what_is_known(plan, index, constants);
  const fn::Selection selection(plan.diagram.uses_libm);
  try {
    known.type().configure(block, is);
  } catch (const ParameterRefused& refused) {
    faults.add(fault_of(plan, index, refused));
  } catch (const io::EnvironmentError& error) {
    throw io::EnvironmentError(plan.diagram.fault(known.origin, known.name, error.what()).text());
  }
  return is.answers();
}

void spread(AnyBlock& block, const ParameterSpec& spec, Eigen::Index size) {
  const Value value = spec.get(block.get());
  const double number = std::get<Eigen::VectorXd>(value.content)[0];
  spec.set(block.get(), {Eigen::VectorXd(Eigen::VectorXd::Constant(size, number))});
}

void prepare(const Plan& plan, std::size_t index, void* block) {
  const BlockType& type = plan.diagram.blocks[index].type();
  for (const ClockSpec& clock : type.clocks)
    if (clock.bind_period) clock.bind_period(block, period_of(plan, index));
  if (!type.prepare) return;
  const fn::Selection selection(plan.diagram.uses_libm);
  type.prepare(block);
}

void configure_blocks(Draft& draft) {
  for (std::size_t i = 0; i < draft.blocks.size(); ++i) {
    diagram::DiagramBlock& block = draft.diagram().blocks[i];
    PlannedBlock& planned = draft.plan.blocks[i];
    const BlockType& type = block.type();
    Draft::Block& made = draft.blocks[i];
    made.computes = bool(type.run_outputs);
    made.differs_at_instants = bool(type.run_outputs_at_instant);
    made.updates = bool(type.run_update);
    made.updates_before_instant = bool(type.run_update_before_instant);
    if (type.configure || type.prepare) planned.written = block.block;
    if (!type.configure) continue;
    made.says = configure(draft.plan, i, block.block.get(), draft.report.faults());
    for (const auto& [input, reason] : made.says.required)
      draft.report.add(block.origin, block.name,
                       fmt::format("the input '{}' is missing ({})", input, reason));
    for (const auto& [variable, unit] : made.says.units)
      if (const auto parsed = unit::parse_unit(unit))
        block.known_units.emplace_back(variable, parsed->dimension);
    made.computes = made.computes && !made.says.skips_outputs;
    made.differs_at_instants = made.differs_at_instants && !made.says.skips_instants;
    made.updates = made.updates && !made.says.skips_update;
    made.updates_before_instant = made.updates_before_instant && !made.says.skips_before_instant;
    planned.configuration = std::make_shared<const Configuration>(made.says);
  }
}

void prepare_blocks(Draft& draft) {
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    prepare(draft.plan, b, draft.diagram().blocks[b].block.get());
}

}  // namespace stepwire::plan
