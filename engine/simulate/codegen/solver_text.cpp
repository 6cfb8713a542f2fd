#include "engine/simulate/codegen/solver_text.hpp"

#include <fmt/format.h>

#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/solve/additions.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

constexpr std::size_t few = 16;  // states that are written out one by one

class ExplicitText {
 public:
  ExplicitText(const std::vector<solve::SolverStage>& stages, const plan::Plan& plan, bool small, bool begins)
      : stages_(stages),
        states_(plan.layout.state_count),
        small_(small),
        begins_(begins),
        timed_(!plan.timed.empty()) {}

  std::string text() const {
    std::string text = small_ ? fmt::format("  double s[first_derivative], dot[{}];\n", states_)
                              : "  double* const s = w;\n  double* const dot = w + first_derivative;\n";
    for (int place = 0; place < solve::places_of(stages_); ++place)
      text += fmt::format("  double {}[{}];\n", name(place), states_);
    text += each([](const std::string& i) { return fmt::format("start[{0}] = w[states + {0}];", i); });
    if (begins_) text += "  derivatives(w, numbers, dot);\n";
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

  std::string evaluation_text(double fraction) const {
    const std::string time = fraction == 1.0 ? "end" : fmt::format("now + {} * step", number_text(fraction));
    std::string text = fmt::format("  w[at::time] = {};\n", time);
    if (small_) text += "  s[at::time] = w[at::time];\n";
    if (timed_) text += "  follow_time(w, numbers);\n";
    return text + "  slopes(w, s, numbers, dot);\n";
  }

  template <class Statement>
  std::string each(const Statement& statement) const {
    if (states_ > few)
      return fmt::format("#pragma GCC ivdep\n  for (int i = 0; i < {}; ++i) {{ {} }}\n", states_,
                         statement("i"));
    std::string text;
    for (std::size_t i = 0; i < states_; ++i) text += fmt::format("  {}\n", statement(std::to_string(i)));
    return text;
  }

  /// A slope is added to all sums on one way through memory.
  std::string additions_text(const solve::SolverStage& stage, bool last) const {
    const auto element = [&](int place, const std::string& i) {
      if (place != solve::Addition::states) return fmt::format("{}[{}]", name(place), i);
      return fmt::format("{}[states + {}]", last ? "w" : "s", i);
    };
    return each([&](const std::string& i) {
      std::string text;
      for (const solve::Addition& addition : stage.additions)
        text +=
            fmt::format("{}{} = {} + (step * {}) * dot[{}];", text.empty() ? "" : " ",
                        element(addition.to, i), element(addition.from, i), number_text(addition.weight), i);
      return text;
    });
  }

  const std::vector<solve::SolverStage>& stages_;
  std::size_t states_;
  bool small_, begins_, timed_;
};

std::string implicit_text(const solve::ImplicitMethod& method, const plan::Plan& plan, bool begins) {
  return fmt::format(
      "  double* const dot = w + first_derivative;\n{5}"
      "  {0}<{1}> method({1});\n"
      "  method.advance(w + states, dot, w + at::time, now, end, step, {{w + {2}, {3}}}, [&] {{{4} slopes(w, "
      "w, "
      "numbers, dot); }});\n",
      method.type, plan.layout.state_count, plan.layout.report, number_text(plan.diagram.tolerance),
      plan.timed.empty() ? "" : " follow_time(w, numbers);",
      begins ? "  derivatives(w, numbers, dot);\n" : "");
}

}  // namespace

std::string solver_text(const plan::Plan& plan, bool small, bool begins) {
  if (const auto tableau = solve::find_tableau(plan.diagram.solver))
    return ExplicitText(solve::stages_of(*tableau), plan, small, begins).text();
  return implicit_text(*solve::find_implicit(plan.diagram.solver), plan, begins);
}

}  // namespace stepwire::codegen
