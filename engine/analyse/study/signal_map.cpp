#include "engine/analyse/study/signal_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/external_input.hpp"

namespace stepwire::study {

namespace {

bool is(const diagram::Source& source, const diagram::SignalRef& signal) {
  return source.block == signal.block && source.output == signal.output;
}

/// Marks the blocks on which `to` depends, without those before `from`.
std::vector<char> blocks_between(const diagram::Diagram& diagram, const diagram::SignalRef& from,
                                 const diagram::SignalRef& to) {
  std::vector<char> between(diagram.blocks.size(), 0);
  std::vector<int> open{to.block};
  while (!open.empty()) {
    const auto block = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (std::exchange(between[block], 1)) continue;
    for (const auto& sources : diagram.blocks[block].inputs)
      for (const diagram::Source& source : sources)
        if (source.block >= 0 && !is(source, from)) open.push_back(source.block);
  }
  return between;
}

/// True for a block whose outputs depend on its inputs only. States without an update are modes, which follow
/// from the inputs.
bool is_function(const BlockType& type) {
  return !type.has_continuous_state() && type.clocks.empty() && !type.run_update;
}

diagram::DiagramBlock point_source(const diagram::Diagram& diagram, const diagram::SignalRef& from) {
  diagram::DiagramBlock block("point", diagram::external_input_type());
  static_cast<diagram::ExternalInput*>(block.block.get())->value =
      PerElement(Numbers(std::vector<double>(2, 0.0)));
  block.parameter_marks.resize(1);
  block.parameter_dimensions.resize(1);
  block.origin = diagram.blocks[static_cast<std::size_t>(from.block)].origin;
  return block;
}

/// Returns a diagram without blocks that runs a single step.
diagram::Diagram empty_part(const diagram::Diagram& diagram) {
  diagram::Diagram part;
  part.file = diagram.file;
  part.scopes = diagram.scopes;
  part.step = part.stop = diagram.step;
  part.step_origin = diagram.step_origin;
  part.stop_origin = diagram.stop_origin;
  return part;
}

/// Rewires blocks to their new indices; readers of `from` are connected to the block `input`.
void rewire(std::vector<diagram::DiagramBlock>& blocks, const std::vector<int>& place,
            const diagram::SignalRef& from, int input) {
  for (diagram::DiagramBlock& block : blocks)
    for (auto& sources : block.inputs)
      for (diagram::Source& source : sources) {
        if (source.block < 0) continue;
        const bool cut = is(source, from);
        source.block = cut ? input : place[static_cast<std::size_t>(source.block)];
        if (cut) source.output = 0;
      }
}

/// Returns the diagram of these blocks with one input; `to` is updated to the signal in it.
diagram::Diagram cut_out(const diagram::Diagram& diagram, const std::vector<char>& between,
                         const diagram::SignalRef& from, diagram::SignalRef& to) {
  diagram::Diagram part = empty_part(diagram);
  std::vector<int> place(between.size(), -1);
  for (std::size_t b = 0; b < between.size(); ++b) {
    if (!between[b]) continue;
    place[b] = static_cast<int>(part.blocks.size());
    part.blocks.push_back(diagram.blocks[b]);
    part.blocks.back().every.reset();  // a function needs no rate
  }
  const int input = static_cast<int>(part.blocks.size());
  rewire(part.blocks, place, from, input);
  part.inputs.push_back({"", input, ""});
  part.blocks.push_back(point_source(diagram, from));
  to.block = place[static_cast<std::size_t>(to.block)];
  return part;
}

}  // namespace

SignalMap::SignalMap(const diagram::Diagram& diagram, const diagram::SignalRef& from,
                     const diagram::SignalRef& to, const yaml::Place& place) {
  const std::vector<char> between = blocks_between(diagram, from, to);
  for (std::size_t b = 0; b < between.size(); ++b) {
    const diagram::DiagramBlock& block = diagram.blocks[b];
    if (between[b] && !is_function(block.type()))
      throw yaml::Error(yaml::Fault{
          place,
          "study.way_back",
          fmt::format("is no function of the place alone: '{}' ({}), on which it depends, "
                      "remembers or follows from the time. Take the direction from the map itself, "
                      "or say from which recorded signal it follows: {{direction: .., position: ..}}",
                      block.name, block.type().name),
          {}});
  }
  diagram::SignalRef result = to;
  plan_ = std::make_unique<const plan::Plan>(plan::make_plan(cut_out(diagram, between, from, result)));
  simulation_ = std::make_unique<run::Executor>(*plan_);
  start_ = simulation_->workspace();
  result_ = plan_->slot(result).offset;
}

Eigen::Vector2d SignalMap::operator()(const Eigen::Vector2d& point) const {
  simulation_->restore(start_);
  simulation_->write_input(0, point.data());
  simulation_->evaluate();
  const double* value = simulation_->values() + result_;
  return {value[0], value[1]};
}

}  // namespace stepwire::study
