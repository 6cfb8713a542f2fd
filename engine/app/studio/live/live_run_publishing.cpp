// Publisher thread: sends news and frames to the pages.
#include <chrono>

#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/run_results.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr double between_looks = 0.004, idle = 0.05;                                          // [s]
constexpr double between_news = 1.0 / 30.0, between_scenes = 0.0158, between_timings = 0.25;  // [s]

const char* word_of(RunStatus::State state) {
  if (state == RunStatus::State::playing) return "playing";
  return state == RunStatus::State::paused ? "paused" : "ended";
}

Json news_of(const RunStatus& status) {
  return Json::object()
      .set("news", "run")
      .set("run", status.run)
      .set("state", word_of(status.state))
      .set("time", status.time)
      .set("tick", status.tick)
      .set("rate", status.rate)
      .set("wanted", status.wanted)
      .set("missed", status.missed)
      .set("compiled", status.compiled)
      .set("fault", status.fault.empty() ? Json() : Json(status.fault));
}

bool has_turned(const std::optional<RunStatus>& before, const RunStatus& now) {
  return !before || before->state != now.state || before->run != now.run || before->fault != now.fault ||
         before->wanted != now.wanted || before->compiled != now.compiled;
}

}  // namespace

void LiveRun::wake() {
  {
    const std::lock_guard lock(wake_mutex_);
    if (std::exchange(is_woken_, true)) return;
  }
  changed_.notify_one();
}

void LiveRun::publish() {
  std::unique_lock lock(wake_mutex_);
  while (!quits_) {
    changed_.wait_for(lock, std::chrono::duration<double>(idle), [this] { return is_woken_ || quits_; });
    is_woken_ = false;
    lock.unlock();
    Loaded run;
    {
      const std::lock_guard loading(mutex_);
      run = loaded_;
    }
    if (run) publish_now(run, seconds_now());
    run.reset();
    lock.lock();
    changed_.wait_for(lock, std::chrono::duration<double>(between_looks), [this] { return quits_; });
  }
}

void LiveRun::publish_now(const Loaded& run, double now) {
  try {
    views_.send(*run);
    publish_run(run, now);
    publish_scene(run, now);
  } catch (const std::exception& error) {
    sinks_.news(Json::object().set("news", "fault").set("text", error.what()));
  }
}

void LiveRun::publish_run(const Loaded& run, double now) {
  const RunStatus status = run->thread().status();
  const bool turned = has_turned(told_, status);
  const bool moved = told_ && status.tick != told_->tick && now - told_at_ >= between_news;
  publish_loop(run, turned, now);
  if (!turned && !moved) return;
  const bool ends = status.state == RunStatus::State::ended &&
                    (!told_ || told_->state != RunStatus::State::ended || told_->run != status.run);
  told_ = status;
  told_at_ = now;
  sinks_.news(news_of(status));
  if (ends && !loop_ && !run->model().claims.empty())
    judge_ = std::jthread([this, run] {
      try {
        sinks_.news(claims_now(*run).set("news", "claims"));
      } catch (const std::exception&) {  // the run was destroyed
      }
    });
}

void LiveRun::publish_loop(const Loaded& run, bool turned, double now) {
  const bool goes_on = run->thread().status().state == RunStatus::State::playing;
  if (!loop_ || (!turned && (!goes_on || now - loop_at_ < between_timings))) return;
  loop_at_ = now;
  if (auto timing = run->thread().timing()) sinks_.news(timing->set("news", "loop"));
}

void LiveRun::publish_scene(const Loaded& run, double now) {
  {
    const std::lock_guard lock(mutex_);
    if (scene_watchers_.empty() || !run->model().scene || now - scene_at_ < between_scenes) return;
    if (std::exchange(scene_asked_, false)) scene_tick_ = -1;
  }
  if (scene_of_ != run) {
    scene_.reset();
    scene_of_ = run;
    scene_.emplace(*run);
    scene_tick_ = -1;
  }
  const std::int64_t tick = run->store().end_tick() - 1;
  if (tick == scene_tick_) return;
  scene_tick_ = tick;
  scene_at_ = now;
  if (auto news = scene_->news()) sinks_.news(std::move(*news));
}

}  // namespace stepwire::live
