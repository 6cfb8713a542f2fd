#include "engine/generate/solver_text.hpp"

#include <fmt/format.h>

#include "engine/generate/literals.hpp"
#include "engine/solve/additions.hpp"
#include "engine/solve/solver.hpp"

namespace stepwire {

namespace {

constexpr std::size_t few = 16;  // states that are written out one by one

class ExplicitText {
 public:
  ExplicitText(const std::vector<SolverStage>& stages, std::size_t states, bool small)
      : stages_(stages), states_(states), small_(small) {}

  std::string text() const {
    std::string text = small_ ? fmt::format("  double s[dots], dot[{}];\n", states_)
                              : "  double* const s = w;\n  double* const dot = w + dots;\n";
    for (int place = 0; place < places_of(stages_); ++place)
      text += fmt::format("  double {}[{}];\n", name(place), states_);
    text += each([](const std::string& i) { return fmt::format("start[{0}] = w[states + {0}]", i); });
    text += "  derivatives(w, parameters, dot);\n";
    for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
      if (stage > 0)
        text += fmt::format("  s[at::time] = now + {} * step;\n  slopes(w, s, parameters, dot);\n",
                            number_text(stages_[stage - 1].next));
      for (const Addition& addition : stages_[stage].additions)
        text += addition_text(addition, stage + 1 == stages_.size());
    }
    return text;
  }

 private:
  static std::string name(int place) {
    return place == Addition::start ? "start" : fmt::format("sum_{}", place);
  }

  template <class Statement>
  std::string each(const Statement& statement) const {
    if (states_ > few) return fmt::format("  for (int i = 0; i < {}; ++i) {};\n", states_, statement("i"));
    std::string text;
    for (std::size_t i = 0; i < states_; ++i) text += fmt::format("  {};\n", statement(std::to_string(i)));
    return text;
  }

  std::string addition_text(const Addition& addition, bool last) const {
    const auto element = [&](int place, const std::string& i) {
      if (place != Addition::states) return fmt::format("{}[{}]", name(place), i);
      return fmt::format("{}[states + {}]", last ? "w" : "s", i);
    };
    return each([&](const std::string& i) {
      return fmt::format("{} = {} + (step * {}) * dot[{}]", element(addition.to, i),
                         element(addition.from, i), number_text(addition.weight), i);
    });
  }

  const std::vector<SolverStage>& stages_;
  std::size_t states_;
  bool small_;
};

std::string rosenbrock_text(std::size_t states) {
  return fmt::format(
      "  double* const dot = w + dots;\n"
      "  derivatives(w, parameters, dot);\n"
      "  Rosenbrock<{0}> method({0});\n"
      "  method.advance(w + states, dot, w + at::time, now, step, [&] {{ slopes(w, w, parameters, dot); "
      "}});\n",
      states);
}

}  // namespace

std::string solver_text(const Plan& plan, bool small) {
  const std::size_t states = plan.layout.state_count;
  if (const auto tableau = find_tableau(plan.diagram.solver))
    return ExplicitText(stages_of(*tableau), states, small).text();
  return rosenbrock_text(states);
}

}  // namespace stepwire
