#include "engine/simulate/run/stepper.hpp"

#include <algorithm>

#include "engine/simulate/run/solver_of.hpp"

namespace stepwire::run {

/// Differential equations of the diagram, as the solver evaluates them at its stages.
struct Stepper::Equations : solve::System {
  explicit Equations(Stepper& stepper) : of(stepper) {
    const plan::Layout& layout = of.plan_.layout;
    time = of.values_ + plan::Layout::time;
    x = of.values_ + layout.states;
    dot = of.values_ + layout.derivatives;
    count = layout.state_count;
    report = {of.values_ + layout.report, of.plan_.diagram.tolerance};
    moving = {{0, count}};
    moving.reserve(of.states_.size() + 1);
  }
  /// Finds the ranges of states that the solver integrates: those without an inactive guard.
  void find_moving() {
    const std::size_t first = of.plan_.layout.states;
    moving.clear();
    for (const plan::ActivePiece& piece : of.states_)
      if (piece.active < 0 || of.values_[piece.active] != 0.0)
        moving.push_back({piece.first - first, piece.end - first});
    if (moving.empty()) moving.push_back({0, 0});
  }
  bool stops(double at) override { return ask && (*ask)(at); }
  void evaluate() override {
    of.follow_time();
    of.find_outputs();
    of.find_slopes();
  }

  Stepper& of;
  const solve::Stops* ask = nullptr;
};

Stepper::Stepper(BoundBlocks& blocks, Participants& who)
    : plan_(blocks.plan()),
      values_(blocks.values()),
      guarded_(who.guards.has_value()),
      timed_(plan_.timed, blocks, who),
      stage_(plan_.stage, blocks, who),
      derivatives_(plan_.derivatives, blocks, who),
      states_(plan::active_pieces(plan_, plan_.layout.states, plan_.layout.derivatives)),
      solver_(solver_of(plan_)),
      equations_(std::make_unique<Equations>(*this)) {}

Stepper::~Stepper() = default;

void Stepper::follow_time() {
  if (values_[plan::Layout::timed] == values_[plan::Layout::time] || timed_.empty()) return;
  values_[plan::Layout::timed] = values_[plan::Layout::time];
  timed_.run();
}

void Stepper::advance(const solve::TimeStep& step, const solve::Stops* stops) {
  if (guarded_) equations_->find_moving();
  equations_->ask = stops;
  solver_->advance(*equations_, step);
}

void Stepper::step(const solve::TimeStep& step) {
  if (!moves()) return;
  find_slopes();
  advance(step);
}

void Stepper::step_to(std::int64_t tick, double end) {
  const double begin = plan_.time_of(tick);
  if (moves()) {
    find_slopes();
    advance({begin, end, end - begin});
  }
  values_[plan::Layout::time] = end;
  follow_time();
}

void Stepper::copy_start(double* states) const {
  if (!moves()) return;
  for (const solve::StatePiece& piece : equations_->moving)
    std::copy(solver_->start() + piece.first, solver_->start() + piece.end, states + piece.first);
}

}  // namespace stepwire::run
