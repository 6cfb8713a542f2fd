// Loading of a model, as a simulation or as a real-time loop.
#include <stdexcept>

#include "engine/app/studio/live/live_folder.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/loop_thread.hpp"
#include "engine/app/studio/live/run_description.hpp"
#include "engine/app/studio/live/run_thread.hpp"

namespace stepwire::live {

using json::Json;

void LiveRun::put(Loaded next) {
  Loaded before;
  {
    const std::lock_guard lock(mutex_);
    before = std::exchange(loaded_, std::move(next));
    runs_ = loaded_->thread().status().run + 1;
    if (fan_interrupt_) *fan_interrupt_ = true;
  }
  if (before) before->thread().pause();
  wake();
}

MakeRun LiveRun::run_of(std::uint32_t number) {
  if (loop_)
    return [this, number](const plan::Plan& plan, const SignalList& signals) {
      return std::make_unique<LoopThread>(plan, signals,
                                          LoopThread::Options{*loop_, {}, number, [this] { wake(); }});
    };
  return [this, number](const plan::Plan& plan, const SignalList& signals) {
    return std::make_unique<RunThread>(plan, signals,
                                       RunThread::Options{&code_, {}, number, [this] { wake(); }});
  };
}

/// Returns the running loop of the same model, which a further page joins; nullptr if there is none.
LiveRun::Loaded LiveRun::going_loop(const session::LoadedModel& model) const {
  const std::lock_guard lock(mutex_);
  const bool same = loop_ && loaded_ && loaded_->model().file == model.file &&
                    loaded_->model().hash == model.hash &&
                    loaded_->thread().status().state == RunStatus::State::playing;
  return same ? loaded_ : nullptr;
}

Json LiveRun::describe(LoadedRun& run) const {
  Json description = run_description(run);
  if (!loop_) return description;
  const Json settings = Json::object()
                            .set("rate", loop_->rate)
                            .set("period", 1.0 / loop_->rate)
                            .set("policy", realtime::policy_text(loop_->policy))
                            .set("overrun", realtime::overrun_text(loop_->overrun));
  return description.set("stop", Json()).set("claims", Json::list()).set("loop", settings);
}

Json LiveRun::load(int, const Arguments& arguments) {
  Loading loading = load_(static_cast<int>(arguments.number("file")), arguments.flag_or("hand", true));
  if (const Loaded going = going_loop(loading.model)) return describe(*going);
  std::uint32_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (loaded_) runs_ = std::max(runs_, loaded_->thread().status().run + 1);
    number = runs_;
  }
  const auto run = std::make_shared<LoadedRun>(std::move(loading), run_of(number));
  Json description = describe(*run);
  put(run);
  return description;
}

void LiveRun::refuse_in_loop(const char* what) const {
  if (loop_)
    throw std::runtime_error(std::string("there is no '") + what +
                             "' beside a real-time loop, which it might disturb");
}

Json LiveRun::keep(int, const Arguments&) {
  const Loaded run = loaded();
  const std::string folder = out_.empty() ? folder_beside(run->model().file) : out_;
  run->thread().pause();
  write_live_folder(folder, *run);
  return Json::object().set("folder", folder);
}

Json LiveRun::loop(int, const Arguments&) {
  const auto timing = loaded()->thread().timing();
  if (!timing) throw std::runtime_error("this run is no real-time loop; 'stepwire studio --loop' makes one");
  return *timing;
}

}  // namespace stepwire::live
