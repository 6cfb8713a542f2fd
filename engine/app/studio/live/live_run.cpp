#include "engine/app/studio/live/live_run.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "engine/app/studio/live/arguments.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/fan.hpp"
#include "engine/app/studio/live/live_folder.hpp"
#include "engine/app/studio/live/loop_thread.hpp"
#include "engine/app/studio/live/mechanisms.hpp"
#include "engine/app/studio/live/run_description.hpp"
#include "engine/app/studio/live/run_results.hpp"
#include "engine/app/studio/live/run_thread.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::live {

using json::Json;

namespace {

constexpr double fastest = 10.0, slowest = 0.1;  // rates

bool is_file(const diagram::Diagram& diagram, const diagram::Target& target) {
  if (target.kind != diagram::Target::Kind::parameter) return false;
  const BlockType& type = diagram.blocks[static_cast<std::size_t>(target.block)].type();
  return type.parameters[static_cast<std::size_t>(target.index)].kind == ParameterKind::file;
}

/// Refuses to set a file name: the access to files is only checked when a text is loaded.
void refuse_file(const diagram::Diagram& diagram, const std::string& name) {
  const diagram::Variation variation(diagram, {name});
  if (std::ranges::any_of(variation.targets(), [&](const auto& target) { return is_file(diagram, target); }))
    throw std::runtime_error("'" + name +
                             "' names a file, and cannot be set in a run; write it into the text");
}

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

LiveRun::LiveRun(Load load, Sinks sinks, LiveOptions options)
    : load_(std::move(load)),
      sinks_(std::move(sinks)),
      loop_(std::move(options.loop)),
      out_(std::move(options.out)),
      views_(sinks_.frame) {
  publisher_ = std::thread([this] { publish(); });
}

LiveRun::~LiveRun() {
  {
    const std::lock_guard lock(wake_mutex_);
    quits_ = true;
  }
  changed_.notify_one();
  publisher_.join();
  if (fan_interrupt_) *fan_interrupt_ = true;
  judge_ = {};
  scene_.reset();
  scene_of_.reset();
  loaded_.reset();  // stops its thread, which wakes the publisher
}

const std::map<std::string, LiveRun::Call>& LiveRun::calls() {
  static const std::map<std::string, Call> all{
      {"run.load", &LiveRun::load},       {"run.play", &LiveRun::play},
      {"run.pause", &LiveRun::pause},     {"run.tick", &LiveRun::tick},
      {"run.restart", &LiveRun::restart}, {"run.seek", &LiveRun::seek},
      {"run.set", &LiveRun::set},         {"run.input", &LiveRun::input},
      {"run.log", &LiveRun::log},         {"clock", &LiveRun::clock},
      {"scope.signal", &LiveRun::signal}, {"data.want", &LiveRun::want},
      {"data.export", &LiveRun::csv},     {"data.statistics", &LiveRun::statistics},
      {"figures", &LiveRun::figures},     {"claims", &LiveRun::claims},
      {"fan", &LiveRun::fan_of},          {"scene", &LiveRun::scene},
      {"mechanism", &LiveRun::mechanism}, {"scene.watch", &LiveRun::watch_scene},
      {"profile", &LiveRun::profile},     {"loop", &LiveRun::loop},
      {"run.keep", &LiveRun::keep}};
  return all;
}

std::vector<std::string> LiveRun::call_names() {
  std::vector<std::string> names;
  for (const auto& [name, call] : calls()) names.push_back(name);
  return names;
}

Json LiveRun::call(int page, const std::string& name, const Json& arguments) {
  const auto found = calls().find(name);
  if (found == calls().end()) throw std::runtime_error("there is no call '" + name + "'");
  heard(page);
  return (this->*found->second)(page, Arguments(arguments));
}

/// Records that a page is alive; any message counts.
void LiveRun::heard(int page) {
  const std::lock_guard lock(mutex_);
  if (loaded_) loaded_->thread().heard(page);
}

void LiveRun::acknowledge(int page, std::uint32_t sequence) {
  heard(page);
  views_.acknowledge(page, sequence);
  wake();
}

void LiveRun::left(int page) {
  views_.left(page);
  const std::lock_guard lock(mutex_);
  gone_.insert(page);
  if (loaded_) loaded_->thread().release(page);
  clocks_.erase(page);
  scene_watchers_.erase(page);
}

LiveRun::Loaded LiveRun::loaded() const {
  const std::lock_guard lock(mutex_);
  if (!loaded_) throw std::runtime_error("no model is loaded; run.load comes first");
  return loaded_;
}

Json LiveRun::moment(LoadedRun& run) const {
  const RunStatus status = run.thread().status();
  return Json::object().set("tick", status.tick).set("time", status.time);
}

Json LiveRun::play(int, const Arguments& arguments) {
  const double rate = arguments.number_if_any("rate").value_or(1.0);
  if (rate != 0.0 && (rate < slowest || rate > fastest))
    throw std::runtime_error("the rate is 0 (as fast as it goes) or from 0.1 to 10");
  const Loaded run = loaded();
  run->thread().play(rate);
  return moment(*run);
}

Json LiveRun::pause(int, const Arguments&) {
  const Loaded run = loaded();
  run->thread().pause();
  return moment(*run);
}

Json LiveRun::tick(int, const Arguments&) {
  const Loaded run = loaded();
  const std::int64_t tick = run->thread().one_tick();
  return Json::object().set("tick", tick).set("time", run->plan().time_of(tick));
}

Json LiveRun::restart(int, const Arguments&) {
  loaded()->thread().restart();
  return Json::object().set("tick", 0).set("time", 0.0);
}

Json LiveRun::seek(int, const Arguments& arguments) {
  const Loaded run = loaded();
  const std::int64_t tick = run->thread().seek(arguments.number("time"));
  return Json::object().set("tick", tick).set("time", run->plan().time_of(tick));
}

Json LiveRun::set(int, const Arguments& arguments) {
  const std::string name = arguments.text("name");
  refuse_file(loaded()->plan().diagram, name);
  const auto number = arguments.number_if_no_text("value");
  const SetResult set =
      loaded()->thread().set(name, number ? fmt::format("{}", *number) : arguments.text("value"));
  Json echo = Json::object()
                  .set("name", name)
                  .set("value", set.value ? Json(*set.value) : Json())
                  .set("text", set.text)
                  .set("tick", set.tick);
  sinks_.news(Json(echo).set("news", "set"));
  return echo;
}

Json LiveRun::input(int page, const Arguments& arguments) {
  const Loaded run = loaded();
  const double now = seconds_now();
  for (const Json& item : arguments.list("samples").items()) {
    const Arguments sample(item);
    const double shown = sample.number("time");
    const std::lock_guard lock(mutex_);
    if (gone_.contains(page)) return {};  // no later call would release inputs of a page that has left
    PageClock& clock = clocks_[page];
    clock.came(shown, now);
    run->thread().input({page, clock.here(shown), sample.text("name"), sample.numbers("values"), shown});
  }
  return {};
}

Json LiveRun::log(int, const Arguments&) {
  const Loaded run = loaded();
  Json settings = Json::list();
  for (const diagram::Setting& setting : run->model().options.settings)
    settings.push(Json::object().set("name", setting.name).set("text", setting.value));
  return Json::object()
      .set("file", run->model().file)
      .set("hash", run->model().hash)
      .set("settings", std::move(settings))
      .set("events", run->thread().log().json());
}

Json LiveRun::clock(int page, const Arguments& arguments) {
  const double shown = arguments.number("page"), now = seconds_now();
  const std::lock_guard lock(mutex_);
  clocks_[page].came(shown, now);
  return Json::object().set("page", shown).set("server", now);
}

Json LiveRun::signal(int, const Arguments& arguments) {
  const Loaded run = loaded();
  const std::size_t index = run->find(arguments.text("expression"));
  const LiveColumn column = run->column(index);
  run->stored(index);
  return Json::object()
      .set("column", index)
      .set("name", column.name)
      .set("unit", column.unit)
      .set("scale", column.scale)
      .set("offset", column.offset);
}

Json LiveRun::want(int page, const Arguments& arguments) {
  views_.want(page, arguments.list("views"));
  wake();
  return Json::object();
}

Json LiveRun::statistics(int, const Arguments& arguments) {
  return statistics_of(*loaded(), arguments.indices("columns"), arguments.number("from"),
                       arguments.number("to"));
}

Json LiveRun::csv(int, const Arguments& arguments) {
  return Json::object().set("csv", csv_of(*loaded(), arguments.indices("columns"), arguments.number("from"),
                                          arguments.number("to")));
}

Json LiveRun::figures(int, const Arguments&) {
  return figures_now(*loaded());
}

Json LiveRun::claims(int, const Arguments&) {
  if (loop_) return Json::object().set("claims", Json::list());
  return claims_now(*loaded());
}

Json LiveRun::fan_of(int, const Arguments& arguments) {
  refuse_in_loop("fan");
  const FanCall call{arguments.text("name"), arguments.number("low"), arguments.number("high"),
                     static_cast<std::size_t>(std::max(0.0, arguments.number("count"))),
                     arguments.indices("columns")};
  const auto interrupt = std::make_shared<std::atomic<bool>>(false);
  {
    const std::lock_guard lock(mutex_);
    if (fan_interrupt_) *fan_interrupt_ = true;
    fan_interrupt_ = interrupt;
  }
  return fan(*loaded(), call, *interrupt);
}

Json LiveRun::scene(int, const Arguments&) {
  const Loaded run = loaded();
  return Json::object().set("scene", run->model().scene ? SceneNow(*run).description() : Json());
}

Json LiveRun::mechanism(int, const Arguments&) {
  return mechanisms_of(*loaded());
}

Json LiveRun::watch_scene(int page, const Arguments& arguments) {
  const bool on = arguments.flag("on");
  const std::lock_guard lock(mutex_);
  if (on) scene_watchers_.insert(page);
  if (!on) scene_watchers_.erase(page);
  scene_asked_ = true;
  return Json::object();
}

Json LiveRun::profile(int, const Arguments&) {
  refuse_in_loop("profile");
  const std::atomic<bool> interrupt = false;
  return profile_now(*loaded(), interrupt);
}

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
