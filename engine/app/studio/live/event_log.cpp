#include "engine/app/studio/live/event_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/text/count.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::live {

namespace {

using json::Json;

double number_of(const Json& object, const char* key) {
  const Json* found = object.find(key);
  const auto number = found ? found->as_number() : std::nullopt;
  if (!number) throw std::runtime_error(fmt::format("an event has no number '{}'", key));
  return *number;
}

std::string text_of(const Json& object, const char* key) {
  const Json* found = object.find(key);
  return found && found->as_text() ? *found->as_text() : "";
}

bool is_before(const LiveEvent& event, std::int64_t tick) {
  return event.tick < tick;
}

std::size_t input_of(const LiveEvent& event, const plan::Plan& plan) {
  const auto& inputs = plan.diagram.inputs;
  const auto found = std::ranges::find(inputs, event.name, &diagram::DiagramInput::name);
  const auto index = static_cast<std::size_t>(found - inputs.begin());
  if (found == inputs.end())
    throw yaml::Error(yaml::Fault{{plan.diagram.file, {}}, event.name, "there is no input of this name", {}});
  const auto size = static_cast<std::size_t>(plan.slot({found->block, 0, -1}).size);
  if (size == event.values.size()) return index;
  const std::string wrong =
      fmt::format("takes {}, not {}", text::counted(size, "number"), event.values.size());
  throw yaml::Error(yaml::Fault{{plan.diagram.file, {}}, event.name, wrong, {}});
}

void set(const LiveEvent& event, run::Executor& run) {
  if (run.set(event.name, event.text) == run::Executor::Setting::done) return;
  throw yaml::Error(yaml::Fault{
      {run.plan().diagram.file, {}},
      event.name,
      yaml::fault_text("cannot be set in a run ({}); write it into the file", run.structure_change()),
      {}});
}

}  // namespace

void EventLog::add(LiveEvent event) {
  const auto behind = std::ranges::upper_bound(events_, event.tick, {}, &LiveEvent::tick);
  events_.insert(behind, std::move(event));
}

void EventLog::cut(std::int64_t tick) {
  events_.erase(std::lower_bound(events_.begin(), events_.end(), tick, is_before), events_.end());
}

void EventLog::each(std::int64_t from, std::int64_t to,
                    const std::function<void(const LiveEvent&)>& take) const {
  auto event = std::lower_bound(events_.begin(), events_.end(), from, is_before);
  for (; event != events_.end() && event->tick < to; ++event) take(*event);
}

std::vector<LiveEvent> EventLog::last_of_each(std::int64_t to) const {
  std::vector<LiveEvent> last;
  each(before_start, to, [&](const LiveEvent& event) {
    std::erase_if(last, [&](const LiveEvent& earlier) { return earlier.name == event.name; });
    last.push_back(event);
  });
  return last;
}

Json EventLog::json() const {
  Json list = Json::list();
  for (const LiveEvent& event : events_) {
    Json one = Json::object().set("tick", event.tick).set("name", event.name);
    if (event.is_input())
      one.set("values", Json::list_of(event.values)).set("time", event.time);
    else
      one.set("text", event.text);
    list.push(std::move(one));
  }
  return list;
}

EventLog EventLog::read(const Json& list) {
  EventLog log;
  for (const Json& one : list.items()) {
    LiveEvent event{static_cast<std::int64_t>(number_of(one, "tick")),
                    text_of(one, "name"),
                    text_of(one, "text"),
                    {},
                    0.0};
    if (const Json* values = one.find("values")) {
      for (const Json& value : values->items()) event.values.push_back(value.as_number().value_or(0.0));
      event.time = number_of(one, "time");
    }
    if (!log.events_.empty() && event.tick < log.events_.back().tick)
      throw std::runtime_error("the ticks of the events do not rise");
    log.add(std::move(event));
  }
  return log;
}

void apply(const LiveEvent& event, run::Executor& run) {
  if (event.is_input())
    run.write_input(input_of(event, run.plan()), event.values.data());
  else
    set(event, run);
}

std::optional<double> present_number(const run::Executor& run, const std::string& name,
                                     const std::string& text) {
  const auto& parameters = run.plan().diagram.parameters;
  const auto found = std::ranges::find(parameters, name, &diagram::DiagramParameter::name);
  if (found != parameters.end()) {
    const Value& value = run.parameter(static_cast<std::size_t>(found - parameters.begin()));
    const double* number = std::get_if<double>(&value.content);
    return number ? std::optional(*number) : std::nullopt;
  }
  const auto quantity = unit::parse_quantity(text);
  return quantity ? std::optional(quantity->value) : std::nullopt;
}

void LogReplay::do_events(run::Executor& run, std::int64_t tick) const {
  log_.each(tick, tick + 1, [&](const LiveEvent& event) { apply(event, run); });
}

void LogReplay::begin(const run::ObservedRun& run) {
  do_events(run.simulation, before_start);
  run.simulation.reset();
}

run::Flow LogReplay::before_tick(const run::ObservedRun& run) {
  do_events(run.simulation, run.simulation.tick());
  return run::Flow::go_on;
}

}  // namespace stepwire::live
