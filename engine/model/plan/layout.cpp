#include <algorithm>
#include <set>

#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/guards.hpp"

namespace stepwire::plan {

namespace {

/// Returns the blocks in the order of their first call, followed by those without calls of outputs, by type.
std::vector<int> memory_order(const Draft& draft, const std::vector<int>& order) {
  std::vector<bool> placed(draft.blocks.size(), false);
  std::vector<int> result;
  for (int block : order) {
    if (placed[static_cast<std::size_t>(block)]) continue;
    placed[static_cast<std::size_t>(block)] = true;
    result.push_back(block);
  }
  const auto called = static_cast<std::ptrdiff_t>(result.size());
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    if (!placed[b]) result.push_back(static_cast<int>(b));
  std::stable_sort(result.begin() + called, result.end(), [&](int a, int b) {
    const auto key = [&](int block) {
      return std::pair(draft.plan.diagram.blocks[static_cast<std::size_t>(block)].guard,
                       std::string_view(draft.type(static_cast<std::size_t>(block)).name));
    };
    return key(a) < key(b);
  });
  return result;
}

/// Assigns offsets in the workspace, section by section, see Layout. Within a section the numbers are in the
/// order of the blocks' memory, so that consecutive calls access neighbouring numbers. Continuous states are
/// in canonical order, so that sums over states do not depend on the file.
class LayoutMaker {
 public:
  explicit LayoutMaker(Draft& draft) : draft_(draft), plan_(draft.plan) {}

  void run() {
    Layout& layout = plan_.layout;
    each([&](std::size_t b) { find_slope(b); });
    layout.signals = end_;
    each([&](std::size_t b) { place_signals(b); });
    layout.states = end_;
    for (const int block : draft_.canonical) place_states(static_cast<std::size_t>(block), true);
    layout.state_count = end_ - layout.states;
    layout.derivatives = end_;
    each([&](std::size_t b) { place_dots(b); });
    end_ += layout.state_count;
    for (const auto& [source, state] : slopes_)
      plan_.blocks[source.first].outputs[source.second] = plan_.blocks[state.first].derivatives[state.second];
    layout.discrete = end_;
    each([&](std::size_t b) { place_states(b, false); });
    layout.discrete_count = end_ - layout.discrete;
    layout.diagnostics = end_;
    each([&](std::size_t b) { place_diagnostics(b); });
    layout.diagnostic_count = end_ - layout.diagnostics;
    each([&](std::size_t b) { place_kept(b); });
    each([&](std::size_t b) { place_late(b); });
    layout.constants = end_;
    each([&](std::size_t b) { place_inputs(b); });
    each([&](std::size_t b) { place_initial(b); });
    layout.report = end_;
    layout.size = layout.events = layout.loops = layout.report + report_size();
  }

 private:
  /// With error control the size of each state follows the numbers of the report.
  std::size_t report_size() const {
    return Layout::report_count + (plan_.diagram.error_control ? plan_.layout.state_count : 0);
  }

  template <class Visit>
  void each(const Visit& visit) {
    for (int block : plan_.memory_order) visit(static_cast<std::size_t>(block));
  }

  /// Lets the source of a block's derivative write the derivative directly, if it writes no other one
  /// already.
  void find_slope(std::size_t b) {
    const auto& [state_name, input_name] = draft_.blocks[b].says.slope_source;
    if (state_name.empty()) return;
    const BlockType& type = draft_.type(b);
    const auto state = static_cast<std::size_t>(type.state(state_name));
    const diagram::Source& source =
        draft_.diagram().blocks[b].inputs[static_cast<std::size_t>(type.input(input_name))].front();
    if (source.block < 0 || !source.element.is_whole()) return;
    const auto from = static_cast<std::size_t>(source.block),
               output = static_cast<std::size_t>(source.output);
    const Draft::Block& feeding = draft_.blocks[from];
    const auto guard_of = [&](std::size_t block) { return draft_.diagram().blocks[block].guard; };
    if (!feeding.computes || feeding.timed || guard_of(from) >= 0 || guard_of(b) >= 0 ||
        feeding.output_sizes[output] != draft_.blocks[b].state_sizes[state])
      return;
    plan_.blocks[b].slope_is_input = slopes_.try_emplace({from, output}, std::pair{b, state}).second;
  }

  void place_diagnostics(std::size_t b) {
    for (std::size_t n = 0; n < draft_.type(b).diagnostics.size(); ++n)
      plan_.blocks[b].diagnostics.push_back(take(1));
  }

  SignalSlot take(Eigen::Index size, Eigen::Index columns = 1) {
    const SignalSlot slot{end_, size, columns};
    end_ += static_cast<std::size_t>(size);
    return slot;
  }

  void place_signals(std::size_t b) {
    PlannedBlock& block = plan_.blocks[b];
    block.outputs.resize(draft_.type(b).outputs.size());
    block.states.resize(draft_.type(b).states.size());
    block.derivatives.resize(draft_.type(b).states.size());
    for (std::size_t o = 0; o < block.outputs.size(); ++o)
      if (!draft_.is_state(b, o) && !slopes_.contains({b, o}))
        block.outputs[o] = take(draft_.blocks[b].output_sizes[o], draft_.blocks[b].output_columns[o]);
  }

  void place_states(std::size_t b, bool continuous) {
    const BlockType& type = draft_.type(b);
    for (std::size_t s = 0; s < type.states.size(); ++s)
      if (type.states[s].continuous == continuous)
        plan_.blocks[b].states[s] = take(draft_.blocks[b].state_sizes[s], draft_.blocks[b].state_columns[s]);
    if (!continuous) return;
    for (std::size_t o = 0; o < type.outputs.size(); ++o)
      if (draft_.is_state(b, o))
        plan_.blocks[b].outputs[o] =
            plan_.blocks[b].states[static_cast<std::size_t>(type.state(type.outputs[o].state))];
  }

  void place_dots(std::size_t b) {
    PlannedBlock& block = plan_.blocks[b];
    for (std::size_t s = 0; s < block.states.size(); ++s)
      if (draft_.type(b).states[s].continuous)
        block.derivatives[s] = {plan_.layout.derivatives + (block.states[s].offset - plan_.layout.states),
                                block.states[s].size, block.states[s].columns};
  }

  void place_inputs(std::size_t b) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[b];
    plan_.blocks[b].inputs.resize(block.inputs.size());
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      for (const diagram::Source& source : block.inputs[i])
        plan_.blocks[b].inputs[i].push_back(slot_of(b, i, source));
  }

  /// Reserves memory for outputs that solver stages write and a guard can deactivate.
  void place_kept(std::size_t b) {
    if (draft_.diagram().blocks[b].guard < 0 || !draft_.blocks[b].in_stages) return;
    for (const Eigen::Index size : draft_.blocks[b].output_sizes) plan_.blocks[b].kept.push_back(take(size));
  }

  bool changes_states(std::size_t b) const {
    return draft_.blocks[b].updates && draft_.type(b).has_continuous_state();
  }
  /// True where updates of other blocks read states that its own update changes.
  bool is_read_late(std::size_t b) const {
    const auto reads = [&](const diagram::Source& source) {
      return source.block == static_cast<int>(b) &&
             draft_.is_state(b, static_cast<std::size_t>(source.output));
    };
    for (std::size_t reader = 0; reader < draft_.blocks.size(); ++reader)
      if (reader != b && changes_states(reader))
        for (const auto& sources : draft_.plan.diagram.blocks[reader].inputs)
          if (std::ranges::any_of(sources, reads)) return true;
    return false;
  }
  void place_late(std::size_t b) {
    if (!changes_states(b) || !is_read_late(b)) return;
    Eigen::Index size = 0;
    std::size_t first = 0;
    for (std::size_t s = draft_.type(b).states.size(); s-- > 0;)
      if (draft_.type(b).states[s].continuous) {
        size += plan_.blocks[b].states[s].size;
        first = plan_.blocks[b].states[s].offset;
      }
    const std::size_t before = take(size).offset, after = take(size).offset;
    plan_.late.push_back({b, first, before, after, static_cast<std::size_t>(size)});
  }

  void place_initial(std::size_t b) {
    if (!is_reset(draft_.diagram(), b)) return;
    const diagram::DiagramBlock& block = draft_.diagram().blocks[b];
    for (std::size_t s = 0; s < block.type().states.size(); ++s) {
      const SignalSlot slot = take(plan_.blocks[b].states[s].size);
      plan_.blocks[b].initial.push_back(slot);
      const auto given = std::ranges::find(block.initial, static_cast<int>(s), &diagram::InitialValue::state);
      for (Eigen::Index k = 0; k < slot.size; ++k)
        plan_.constants.push_back(given == block.initial.end()
                                      ? block.type().states[s].initial
                                      : given->value[given->value.size() == 1 ? 0 : k]);
    }
  }

  SignalSlot slot_of(std::size_t b, std::size_t input, const diagram::Source& source) {
    if (source.block >= 0)
      return element_slot(plan_.blocks[static_cast<std::size_t>(source.block)]
                              .outputs[static_cast<std::size_t>(source.output)],
                          source.element);
    const SignalSlot meant = constant_slot(source);
    const bool list = draft_.type(b).inputs[input].list;
    const Eigen::Index size = list ? meant.size : draft_.blocks[b].input_sizes[input];
    for (Eigen::Index k = 0; k < size; ++k)
      plan_.constants.push_back(
          source.constant[static_cast<Eigen::Index>(meant.offset) + (meant.size == 1 ? 0 : k)]);
    return take(size);
  }

  Draft& draft_;
  Plan& plan_;
  std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>>
      slopes_;  ///< outputs (block, output) stored in the derivatives of states (block, state)
  std::size_t end_ = Layout::first;
};

/// Places the reports of loops at the end of the workspace, with memory for diagnostics of their blocks and
/// for residuals.
void place_loops(Plan& plan, const CallOrder& order) {
  for (const CallOrder::Loop& from : order.loops) {
    SolvedLoop loop{from.path, from.tears, {}, plan.layout.size, 0};
    std::set<int> blocks(order.blocks.begin() + static_cast<std::ptrdiff_t>(from.first),
                         order.blocks.begin() + static_cast<std::ptrdiff_t>(from.end));
    for (const int block : blocks)
      for (const SignalSlot& slot : plan.blocks[static_cast<std::size_t>(block)].diagnostics)
        loop.diagnostics.push_back(slot.offset);
    plan.layout.size += Layout::loop_count + loop.diagnostics.size();
    loop.residuals = plan.layout.size;
    for (const diagram::SignalRef& tear : loop.tears)
      plan.layout.size += static_cast<std::size_t>(plan.slot(tear).size);
    plan.loops.push_back(std::move(loop));
  }
  plan.layout.events = plan.layout.size;
}

}  // namespace

void plan_layout(Draft& draft, const CallOrder& order) {
  Plan& plan = draft.plan;
  plan.memory_order = memory_order(draft, order.blocks);
  for (int b : plan.memory_order) {
    const BlockType& type = draft.type(static_cast<std::size_t>(b));
    plan.block_bytes = (plan.block_bytes + type.alignment - 1) / type.alignment * type.alignment;
    plan.blocks[static_cast<std::size_t>(b)].memory = plan.block_bytes;
    plan.block_bytes += type.bytes;
  }
  LayoutMaker(draft).run();
  place_loops(plan, order);
  if (plan.splits_steps()) plan.layout.size += Layout::event_count + 1 + 4 * plan.crossing_count;
}

}  // namespace stepwire::plan
