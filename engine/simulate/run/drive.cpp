#include "engine/simulate/run/drive.hpp"

namespace stepwire::run {

Drive::Drive(Executor& simulation, std::vector<record::Recorder>& recorders)
    : simulation_(simulation), recorders_(recorders), stopper_(simulation.plan()) {}

Drive::End Drive::run() {
  if (!watched_) {
    watched_.emplace(ObservedRun{index, simulation_}, observers, shows_rows);
    watched_->begin();
  }
  while (true) {
    if (!observers.empty())
      if (const Flow flow = show_tick(); flow != Flow::go_on)
        return flow == Flow::pause ? End::paused : end(End::stopped);
    simulation_.evaluate();
    if (!simulation_.healthy()) return end(End::finished);
    const bool last = simulation_.finished() || stopper_.stops(simulation_.values());
    if (!observers.empty()) watched_->evaluated(last);
    for (record::Recorder& recorder : recorders_)
      recorder.record(simulation_.tick(), simulation_.values(), last);
    if (last) return end(End::finished);
    simulation_.advance();
    if (!simulation_.healthy()) return end(End::finished);
    if (simulation_.tick() % ticks_between_looks != 0) continue;
    if (look) look();
    if (interrupt && *interrupt) return end(End::interrupted);
  }
}

Flow Drive::show_tick() {
  const std::int64_t tick = simulation_.tick();
  const Flow flow = watched_->before_tick();
  if (simulation_.tick() != tick)
    for (record::Recorder& recorder : recorders_) recorder.go_back_to(simulation_.tick());
  return flow;
}

Drive::End Drive::end(End how) {
  watched_->end();
  return how;
}

}  // namespace stepwire::run
