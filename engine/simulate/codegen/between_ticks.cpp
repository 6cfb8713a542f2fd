#include "engine/simulate/codegen/between_ticks.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/external_input.hpp"
#include "engine/simulate/codegen/literals.hpp"

namespace stepwire::codegen {

namespace {

/// True if a call of updates runs this block.
bool runs(const plan::KernelCall& call, const plan::PlannedBlock& block) {
  return call.first <= block.memory && block.memory < call.end;
}

/// True if a block without states is called at ticks only to follow inputs of the diagram, which are read
/// there, or to check signals.
bool has_ticks_of_inputs(const plan::Plan& plan, std::size_t b) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[b];
  const BlockType& type = block.type();
  if (plan.blocks[b].rate.ticks != 1 || block.every || !type.states.empty()) return false;
  return type.timing == Timing::inherited || type.outputs.empty() || &type == &diagram::external_input_type();
}

bool remembers(const plan::Plan& plan, std::size_t b) {
  const auto& says = plan.blocks[b].configuration;
  return !plan.diagram.blocks[b].type().states.empty() && !(says && says->remembers_nothing);
}

/// Returns the first block whose update changes a state; nullptr if no update does.
const diagram::DiagramBlock* first_that_remembers(const plan::Plan& plan) {
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    if (!remembers(plan, b)) continue;
    for (const plan::KernelCall& call : plan.updates)
      if (plan.diagram.blocks[b].type().run_update.contains(call.run) && runs(call, plan.blocks[b]))
        return &plan.diagram.blocks[b];
  }
  return nullptr;
}

constexpr char between_member[] =
    "  /// The same between two events, with the branches of the last evaluate_at(). A source that jumps at "
    "`edge` [s]\n"
    "  /// has not jumped yet.\n"
    "  void evaluate_between(double time, double edge);\n";

/// Placeholders: place of the first state, place of the first derivative, count of states, further members,
/// evaluation between events.
constexpr char members_form[] =
    "  /// For a solver of others: computes outputs and slopes for any time [s], with the inputs, and with "
    "the\n"
    "  /// continuous states that stand in their place.\n"
    "  void evaluate_at(double time);\n{4}"
    "  /// Lets blocks look at what has become of a whole step, after evaluate_at().\n"
    "  void complete_step();\n"
    "  static constexpr int state_count = {2};\n"
    "  double* continuous_states() {{ return w_ + {0}; }}\n"
    "  double* slopes() {{ return w_ + {1}; }}\n{3}\n";

}  // namespace

std::string why_ticks_only(const plan::Plan& plan) {
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const plan::Rate& rate = plan.blocks[b].rate;
    if (rate.kind == plan::Rate::Kind::discrete && !has_ticks_of_inputs(plan, b))
      return fmt::format("{} works every {} s", plan.diagram.blocks[b].name,
                         number_text(plan.time_of(rate.ticks)));
  }
  if (!plan.guards.empty())
    return fmt::format("{} works on condition", plan.diagram.blocks[plan.guards.front().block].name);
  if (const diagram::DiagramBlock* block = first_that_remembers(plan))
    return fmt::format("{} remembers at every step{}", block->name,
                       block->type().parameter("settled")
                           ? ", which it does not with settled: false and without a reset, a command by "
                             "hand, limits of its integral part and clamping (anti_windup: none)"
                           : "");
  if (!plan.loops.empty())
    return fmt::format("the algebraic loop {} is solved on from its last solution", plan.loops.front().path);
  return "";
}

std::string between_ticks_members(const plan::Plan& plan) {
  const std::string crossings =
      plan.crossing_count == 0
          ? ""
          : fmt::format(
                "  /// Numbers that change their sign at events, after evaluate_at().\n"
                "  static constexpr int crossing_count = {};\n  void crossings(double* numbers);\n",
                plan.crossing_count);
  const std::string edges =
      plan.edges.empty()
          ? ""
          : "  /// When a source jumps or bends next [s], after evaluate_at().\n  double next_edge();\n";
  return fmt::format(members_form, plan.layout.states, plan.layout.derivatives, plan.layout.state_count,
                     crossings + edges, plan.between.empty() ? "" : between_member);
}

std::string slopes_of_evaluation(const plan::Plan& plan) {
  return plan.layout.state_count == 0 ? "" : "  derivatives(w, numbers, w + first_derivative);\n";
}

std::string between_ticks_definitions(const plan::Plan& plan, const std::string& numbers,
                                      const std::string& before, const std::string& after) {
  const std::string crossings =
      plan.crossing_count == 0
          ? ""
          : fmt::format("void Diagram::crossings(double* z) {{\n  look(w_, {}, 0, z);\n}}\n\n", numbers);
  const std::string edges =
      plan.edges.empty()
          ? ""
          : fmt::format("double Diagram::next_edge() {{\n  return ::next_edge(w_, {}, 0);\n}}\n\n", numbers);
  const auto evaluation = [&](const char* head, const std::string& time, const char* function) {
    return fmt::format("void Diagram::{} {{\n{}  w_[{}] = {};\n  {}(w_, {});\n{}}}\n\n", head, before,
                       plan::Layout::time, time, function, numbers, after);
  };
  const std::string between =
      plan.between.empty()
          ? ""
          : evaluation("evaluate_between(double time, [[maybe_unused]] double edge)",
                       plan.jumps ? "time < edge ? time : solve::left_of(edge, ::step)" : "time",
                       "::evaluate_between");
  return evaluation("evaluate_at(double time)", "time", "::evaluate_here") + between +
         fmt::format("void Diagram::complete_step() {{\n  ::update(w_, {}, 0);\n}}\n\n", numbers) +
         crossings + edges;
}

}  // namespace stepwire::codegen
