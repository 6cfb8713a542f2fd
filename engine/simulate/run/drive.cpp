#include "engine/simulate/run/drive.hpp"

#include "engine/simulate/run/step_probe.hpp"

namespace stepwire::run {

Drive::Drive(Executor& simulation, std::vector<record::Recorder>& recorders)
    : simulation_(simulation), recorders_(recorders), stopper_(simulation.plan()) {}

Drive::End Drive::run() {
  if (!watched_) {
    watched_.emplace(ObservedRun{index, simulation_}, observers, shows_rows);
    watched_->begin();
    simulation_.show_sides(this);
    prepare_checks();
  }
  while (true) {
    if (simulation_.tick() >= until) return End::paused;
    if (!observers.empty())
      if (const Flow flow = show_tick(); flow != Flow::go_on)
        return flow == Flow::pause ? End::paused : end(End::stopped);
    simulation_.evaluate();
    if (!simulation_.healthy()) return end(End::finished);
    const bool last = is_last();
    record(last);
    check_steps(last);
    if (last || !simulation_.healthy()) return end(End::finished);
    simulation_.advance();
    if (!simulation_.healthy()) return end_by_fault();
    forget_row_of_end();
    if (simulation_.tick() % ticks_between_looks != 0) continue;
    if (look) look();
    if (interrupt && *interrupt) return end(End::interrupted);
  }
}

void Drive::record(bool last) {
  if (!observers.empty()) watched_->evaluated(last);
  for (record::Recorder& recorder : recorders_)
    recorder.record(simulation_.tick(), simulation_.values(), last);
}

bool Drive::is_last() const {
  if (!ends) return false;
  return simulation_.finished() || simulation_.has_stopped() || stopper_.stops(simulation_.values());
}

void Drive::prepare_checks() {
  if (!judges_steps || !ends) return;
  simulation_.prepare_checks();
  next_check_ = next_step_check(simulation_.plan(), simulation_.tick());
}

void Drive::check_steps(bool last) {
  if (simulation_.tick() < next_check_ && !(last && judges_steps)) return;
  last ? simulation_.look_at_end() : simulation_.check_steps();
  next_check_ = next_step_check(simulation_.plan(), simulation_.tick());
}

/// Removes the row of a tick at which a block has ended the run, so that the last row shows the tick after
/// its end.
void Drive::forget_row_of_end() {
  const std::int64_t before = simulation_.tick() - 1;
  if (!simulation_.has_stopped() || simulation_.time() != simulation_.plan().time_of(before)) return;
  for (record::Recorder& recorder : recorders_) recorder.go_back_to(before);
}

void Drive::record_side(const double* values, record::Recorder::Side side) {
  for (record::Recorder& recorder : recorders_)
    if (recorder.records_instants()) recorder.record_side(values, side);
  watched_->side(values);
}

Flow Drive::show_tick() {
  const std::int64_t tick = simulation_.tick();
  const Flow flow = watched_->before_tick();
  if (simulation_.tick() != tick)
    for (record::Recorder& recorder : recorders_) recorder.go_back_to(simulation_.tick());
  return flow;
}

Drive::End Drive::end_by_fault() {
  if (simulation_.has_stopped_between()) record(true);
  return end(End::finished);
}

Drive::End Drive::end(End how) {
  watched_->end();
  return how;
}

}  // namespace stepwire::run
