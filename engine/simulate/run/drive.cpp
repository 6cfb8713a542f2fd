#include "engine/simulate/run/drive.hpp"

namespace stepwire {

Drive::Drive(Executor& simulation, std::vector<Recorder>& recorders)
    : simulation_(simulation), recorders_(recorders), stopper_(simulation.plan()) {}

Drive::End Drive::run() {
  if (!begun_)
    for (RunObserver* observer : observers) observer->begin({index, simulation_});
  begun_ = true;
  while (true) {
    if (!observers.empty())
      if (const Flow flow = show_tick(); flow != Flow::go_on)
        return flow == Flow::pause ? End::paused : end(End::stopped);
    simulation_.evaluate();
    if (!simulation_.healthy()) return end(End::finished);
    record();
    if (simulation_.finished() || stopper_.stops(simulation_.values())) return end(End::finished);
    simulation_.advance();
    if (!simulation_.healthy()) return end(End::finished);
    if (simulation_.tick() % ticks_between_looks != 0) continue;
    if (look) look();
    if (interrupt && *interrupt) return end(End::interrupted);
  }
}

Flow Drive::show_tick() {
  const std::int64_t tick = simulation_.tick();
  Flow flow = Flow::go_on;
  for (RunObserver* observer : observers) flow = std::max(flow, observer->before_tick({index, simulation_}));
  if (simulation_.tick() != tick)
    for (Recorder& recorder : recorders_) recorder.go_back_to(simulation_.tick());
  return flow;
}

void Drive::record() {
  for (RunObserver* observer : observers) observer->evaluated({index, simulation_});
  if (shows_rows && !observers.empty()) show_rows();
  for (Recorder& recorder : recorders_) recorder.record(simulation_.tick(), simulation_.values());
}

void Drive::show_rows() {
  for (std::size_t i = 0; i < recorders_.size(); ++i) {
    if (!recorders_[i].is_due(simulation_.tick())) continue;
    recorders_[i].read(simulation_.values(), row_);
    for (RunObserver* observer : observers) observer->row({index, simulation_}, i, row_);
  }
}

Drive::End Drive::end(End how) {
  for (RunObserver* observer : observers) observer->end({index, simulation_});
  return how;
}

}  // namespace stepwire
