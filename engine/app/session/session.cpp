#include "engine/app/session/session.hpp"

#include "engine/analyse/kept/kept_numbers.hpp"
#include "engine/app/session/ordered_points.hpp"

namespace stepwire::session {

LoadedModel Session::load(const std::string& file, const LoadOptions& options) const {
  return load_model(registry_, file, options);
}

void Session::use_device(device::DeviceUse use) {
  device_use_ = use;
  device_ = use == device::DeviceUse::cpu ? nullptr : std::make_unique<device::GpuRuns>(use);
}

void Session::note_device(const run::LaneReport& report) const {
  if (device_use_ == device::DeviceUse::gpu && monitor_.diagnostic && !report.device.why_not.empty())
    monitor_.diagnostic("on the processor, since " + report.device.why_not);
}

Outcome Session::run(const LoadedModel& model, run::ExecutionMode engine, unsigned threads) {
  Outcome outcome = run_model(model, engine, code_, monitor_, threads, device_.get());
  monitor_.note_interpreted(code_.take_problem());
  note_device(outcome.result.lanes);
  return outcome;
}

Outcome Session::pass(const LoadedModel& model, run::ExecutionMode engine, unsigned threads) {
  OrderedPoints points(model);
  const PointsReport report = run(model, points, engine, threads);
  Outcome outcome = points.outcome();
  outcome.seconds = report.seconds;
  outcome.result.lanes = report.lanes;
  return outcome;
}

PointsReport Session::run(const LoadedModel& model, run::PointExchange& points, run::ExecutionMode engine,
                          unsigned threads) {
  const PointsReport report = run_points(model, engine, code_, monitor_, points, threads, device_.get());
  monitor_.note_interpreted(code_.take_problem());
  note_device(report.lanes);
  return report;
}

estimation::FitResult Session::fit(const LoadedModel& model, const FitCall& call) {
  return fit_model(registry_, model, call, monitor_);
}

LoadedModel Session::fitted(const LoadedModel& model, const estimation::FitResult& result) const {
  return load(model.file, with_fitted(model.options, result));
}

tuning::TuneResult Session::tune(const LoadedModel& model, const TuneCall& call) {
  return tune_model(registry_, model, call, monitor_);
}

LoadedModel Session::tuned(const LoadedModel& model, const tuning::TuneResult& result) const {
  return load(model.file, with_tuned(model.options, result));
}

Studies::Shared Session::study(const LoadedModel& model, const StudyCall& call) {
  return studies_.experiments(registry_, model, call, monitor_);
}

replay::Verification Session::replay(const std::string& folder) const {
  return replay::verify(folder, registry_, monitor_.interrupt, kept::numbers_of_folder);
}

}  // namespace stepwire::session
