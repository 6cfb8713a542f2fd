#include "engine/app/studio/live/live_run.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "engine/app/studio/live/arguments.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/fan.hpp"
#include "engine/app/studio/live/mechanisms.hpp"
#include "engine/app/studio/live/run_description.hpp"
#include "engine/app/studio/live/run_results.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::live {

namespace {

using json::Json;

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

}  // namespace stepwire::live
