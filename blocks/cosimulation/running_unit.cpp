#include "blocks/cosimulation/running_unit.hpp"

#include "engine/base/fmi/unit_error.hpp"

namespace stepwire {

void RunningUnit::prepare(fmi::Setup setup, bool isolated) {
  setup_ = std::move(setup);
  isolated_ = isolated;
  const auto trial = fmi::make_runner(setup_, isolated_);
  trial->exchange().time = 0.0;
  if (!trial->run(fmi::Operation::start)) throw fmi::UnitError(trial->exchange().message);
  kept_ = trial->exchange().kept_numbers;
  const fmi::Description& description = setup_.package->description();
  sizes_.inputs.clear();
  for (const fmi::Variable* input : ports_of(description, fmi::Causality::input))
    sizes_.inputs.push_back(input->size);
  sizes_.outputs = ports_of(description, fmi::Causality::output).size();
  sizes_.numbers_shown = trial->exchange().counts.outputs;
  sizes_.indicators = trial->exchange().counts.indicators;
}

void RunningUnit::start(double time) {
  works_ = true;
  refused_ = nullptr;
  moves = 1;
  last_kept.assign(kept_, 0.0);
  try {
    if (!runner_) runner_ = fmi::make_runner(setup_, isolated_, kept_);
    runner_->exchange().time = time;
    run(fmi::Operation::start);
  } catch (const fmi::UnitError& error) {
    not_started_ = error.what();
    works_ = false;
  }
}

bool RunningUnit::run(fmi::Operation operation) {
  return works_ = works_ && runner_->run(operation);
}

void RunningUnit::refuse(const char* message) {
  if (works_) refused_ = message;
  works_ = false;
}

std::string RunningUnit::message() const {
  if (!runner_) return not_started_;
  return refused_ ? refused_ : runner_->exchange().message;
}

}  // namespace stepwire
