#include "engine/simulate/codegen/solver_text.hpp"

#include <fmt/format.h>

#include "engine/model/plan/active_pieces.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/solve/additions.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

/// Pragma that declares the iterations of the next loop independent, for g++ only; other compilers warn of
/// it.
constexpr char independent[] = "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC ivdep\n#endif\n";

constexpr std::size_t few = 16;  // up to this count, states are written out one by one

class ExplicitText {
 public:
  ExplicitText(const std::vector<solve::SolverStage>& stages, const plan::Plan& plan, const StepForm& form)
      : stages_(stages),
        states_(plan.layout.state_count),
        form_(form),
        timed_(!plan.timed.empty()),
        first_(plan.layout.states),
        pieces_(plan::active_pieces(plan, plan.layout.states, plan.layout.derivatives)) {
    // Stages with numbers of their own store all states.
    if (form.small) pieces_ = {{plan.layout.states, plan.layout.derivatives, -1}};
  }

  std::string text() const {
    std::string text = stage_text();
    for (int place = 0; place < solve::places_of(stages_); ++place)
      text += in_lanes() ? fmt::format("  alignas(64) double {}[{} * lanes];\n", name(place), states_)
                         : fmt::format("  double {}[{}];\n", name(place), states_);
    text += each([&](const std::string& i) { return fmt::format("start[{}] = {};", i, state("w", i)); });
    if (form_.begins) text += "  derivatives(w, numbers, dot);\n";
    for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
      if (stage > 0) text += evaluation_text(stages_[stage - 1].next);
      text += additions_text(stages_[stage], stage + 1 == stages_.size());
    }
    return text;
  }

 private:
  static std::string name(int place) {
    return place == solve::Addition::start ? "start" : fmt::format("sum_{}", place);
  }

  bool in_lanes() const { return form_.lanes.lanes > 1; }

  /// Returns the pointers that a stage works on.
  std::string stage_text() const {
    if (!in_lanes())
      return form_.small
                 ? fmt::format("  [[maybe_unused]] double s[first_derivative];\n  double dot[{}];\n", states_)
                 : "  [[maybe_unused]] double* const s = w;\n  double* const dot = w + first_derivative;\n";
    return form_.small ? fmt::format(
                             "  alignas(64) double s_[first_derivative * lanes], dot_[{} * lanes];\n"
                             "  const Lanes s{{s_}}, dot{{dot_}};\n",
                             states_)
                       : "  const Lanes s = w, dot = w.from(first_derivative);\n";
  }

  /// Returns the i-th state; in lanes, the i-th number of the states of all lanes.
  std::string state(const std::string& numbers, const std::string& i) const {
    return fmt::format(fmt::runtime(in_lanes() ? "{}.first[states * lanes + {}]" : "{}[states + {}]"),
                       numbers, i);
  }

  std::string evaluation_text(double fraction) const {
    std::string text = fmt::format("  w[at::time] = {};\n", stage_time_text(fraction));
    if (form_.small) text += "  s[at::time] = w[at::time];\n";
    if (timed_) text += "  follow_time(w, numbers);\n";
    return text + "  " + form_.slopes + ";\n";
  }

  template <class Statement>
  std::string each(const Statement& statement) const {
    std::string text;
    if (in_lanes()) {
      for (const LanePlaces::Stretch& one : form_.lanes.stretches(first_, first_ + states_))
        text +=
            fmt::format("{}  for (int i = {} * lanes; i < {} * lanes; i += {}) {{ {} }}\n", independent,
                        one.first - first_, one.end - first_, one.differs ? "1" : "lanes", statement("i"));
      return text;
    }
    if (states_ > few) {
      for (const plan::ActivePiece& piece : pieces_) text += piece_text(piece, statement("i"));
      return text;
    }
    for (std::size_t i = 0; i < states_; ++i) text += fmt::format("  {}\n", statement(std::to_string(i)));
    return text;
  }

  std::string piece_text(const plan::ActivePiece& piece, const std::string& statement) const {
    const std::string loop = fmt::format("{}  for (int i = {}; i < {}; ++i) {{ {} }}\n", independent,
                                         piece.first - first_, piece.end - first_, statement);
    return piece.active < 0 ? loop : fmt::format("  if (w[{}] != 0.0) {{\n{}  }}\n", piece.active, loop);
  }

  /// Returns the loop that adds a derivative to all sums in one pass through memory.
  std::string additions_text(const solve::SolverStage& stage, bool last) const {
    const auto element = [&](int place, const std::string& i) {
      if (place != solve::Addition::states) return fmt::format("{}[{}]", name(place), i);
      return state(last ? "w" : "s", i);
    };
    return each([&](const std::string& i) {
      std::string text;
      for (const solve::Addition& addition : stage.additions)
        text += fmt::format("{}{} = {} + (length * {}) * {}[{}];", text.empty() ? "" : " ",
                            element(addition.to, i), element(addition.from, i), number_text(addition.weight),
                            in_lanes() ? "dot.first" : "dot", i);
      return text;
    });
  }

  const std::vector<solve::SolverStage>& stages_;
  std::size_t states_;
  const StepForm& form_;
  bool timed_;
  std::size_t first_;                      ///< Place of the states.
  std::vector<plan::ActivePiece> pieces_;  ///< Pieces without inactive guards.
};

/// Returns an argument of a method: the tolerances and their numbers, or the place for a fault of a step.
std::string task_text(const plan::Plan& plan) {
  const std::size_t report = plan.layout.report;
  if (const auto& control = plan.diagram.error_control)
    return fmt::format("{{{}, {}, {}}}, w + {}", number_text(control->relative),
                       number_text(control->absolute), control->max_steps, report);
  return fmt::format("{{w + {}, {}}}", report, number_text(plan.diagram.tolerance));
}

std::string called_text(const solve::CalledMethod& method, const plan::Plan& plan, const StepForm& form) {
  return fmt::format(
      "  [[maybe_unused]] double* const s = w;\n  double* const dot = w + first_derivative;\n{0}"
      "  {1} method({2});\n"
      "  const auto evaluate = [&] {{{4} {5}; }};\n"
      "  method.advance(w + states, dot, w + at::time, now, end, length, {3}, {6});\n",
      form.begins ? "  derivatives(w, numbers, dot);\n" : "",
      fmt::format(fmt::runtime(method.type), plan.layout.state_count), plan.layout.state_count,
      task_text(plan), plan.timed.empty() ? "" : " follow_time(w, numbers);", form.slopes,
      form.stops.empty() ? "evaluate" : fmt::format("solve::asked(evaluate, {})", form.stops));
}

}  // namespace

std::string stage_time_text(double fraction) {
  return fraction == 1.0 ? "end" : fmt::format("now + {} * length", number_text(fraction));
}

std::string solver_text(const plan::Plan& plan, const StepForm& form) {
  const std::string& name = plan.diagram.solver;
  if (const auto method = solve::find_called(name, plan.diagram.error_control.has_value()))
    return called_text(*method, plan, form);
  return ExplicitText(solve::stages_of(*solve::find_tableau(name)), plan, form).text();
}

}  // namespace stepwire::codegen
