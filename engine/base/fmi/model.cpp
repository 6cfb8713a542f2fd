#include "engine/base/fmi/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {
namespace {

/// Converts a number to the nearest value of a type; integers are rounded and clamped to its range.
template <class Value>
Value nearest(double number) {
  if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<Value>(number);
  } else if constexpr (std::is_same_v<Value, bool>) {
    return number != 0.0;
  } else {
    constexpr auto lowest = std::numeric_limits<Value>::lowest(), largest = std::numeric_limits<Value>::max();
    const double whole = std::round(number);
    if (!(whole > static_cast<double>(lowest))) return lowest;
    return whole < static_cast<double>(largest) ? static_cast<Value>(whole) : largest;
  }
}

/// Calls a function with a value of the corresponding C++ type; Type::other has none.
template <class Function>
void with_type(Type type, const Function& of) {
  if (type == Type::float64) return of(double{});
  if (type == Type::float32) return of(float{});
  if (type == Type::int8) return of(std::int8_t{});
  if (type == Type::uint8) return of(std::uint8_t{});
  if (type == Type::int16) return of(std::int16_t{});
  if (type == Type::uint16) return of(std::uint16_t{});
  if (type == Type::int32) return of(std::int32_t{});
  if (type == Type::uint32) return of(std::uint32_t{});
  if (type == Type::int64) return of(std::int64_t{});
  if (type == Type::uint64) return of(std::uint64_t{});
  if (type == Type::boolean) return of(bool{});
  if (type == Type::wide_boolean) return of(int{});
}

constexpr int most_iterations = 100;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t most_state_bytes = std::size_t{256} << 20;

/// Returns the tolerance for times that a unit accumulates by itself.
double tolerance_at(double time) {
  return 1e-9 * std::max(1.0, std::abs(time));
}

std::vector<std::size_t> discrete_numbers(const Description& description) {
  std::vector<std::size_t> places;
  std::size_t place = 0;
  for (const Variable* input : ports_of(description, Causality::input))
    for (std::size_t i = 0; i < input->size; ++i, ++place)
      if (input->discrete) places.push_back(place);
  return places;
}

}  // namespace

ValueGroups::ValueGroups(const std::vector<const Variable*>& variables, Which which) {
  for (const Variable* variable : variables) {
    if (which == Which::continuous && variable->discrete) {
      count_ += variable->size;
      continue;
    }
    auto group = std::ranges::find(groups_, variable->type, &Group::type);
    if (group == groups_.end()) group = groups_.insert(groups_.end(), Group{variable->type, {}, {}, {}});
    group->references.push_back(variable->reference);
    for (std::size_t i = 0; i < variable->size; ++i)
      group->places.push_back({count_++, variable->factor, variable->offset});
    group->room.resize(group->places.size());
  }
}

bool ValueGroups::get(Calls& calls, double* numbers) {
  for (Group& group : groups_) {
    const std::size_t size = group.places.size();
    if (!calls.get(group.type, group.references.data(), group.references.size(), group.room.data(), size))
      return false;
    with_type(group.type, [&](auto zero) {
      const auto* values = reinterpret_cast<const decltype(zero)*>(group.room.data());
      for (std::size_t i = 0; i < size; ++i) {
        const Place& place = group.places[i];
        const double scaled = place.factor * static_cast<double>(values[i]);
        numbers[place.number] = place.offset == 0.0 ? scaled : place.offset + scaled;  // preserves -0
      }
    });
  }
  return true;
}

bool ValueGroups::set(Calls& calls, const double* numbers) {
  for (Group& group : groups_) {
    const std::size_t size = group.places.size();
    with_type(group.type, [&](auto zero) {
      auto* values = reinterpret_cast<decltype(zero)*>(group.room.data());
      for (std::size_t i = 0; i < size; ++i) {
        const Place& place = group.places[i];
        const bool flag = group.type == Type::wide_boolean;
        const double number = (numbers[place.number] - place.offset) / place.factor;
        values[i] = nearest<decltype(zero)>(flag ? number != 0.0 : number);
      }
    });
    if (!calls.set(group.type, group.references.data(), group.references.size(), group.room.data(), size))
      return false;
  }
  return true;
}

std::vector<const Variable*> ports_of(const Description& description, Causality causality) {
  std::vector<const Variable*> ports;
  for (const Variable& variable : description.variables)
    if (variable.causality == causality && variable.type != Type::other) ports.push_back(&variable);
  return ports;
}

Counts counts_of(const Setup& setup) {
  const Description& description = setup.package->description();
  const bool continuous = setup.mode == Mode::model_exchange;
  return {ValueGroups(ports_of(description, Causality::input)).count(),
          ValueGroups(ports_of(description, Causality::output)).count(),
          continuous ? description.state_count : 0, continuous ? description.indicator_count : 0, 0};
}

Model::Model(const Setup& setup, Exchange& exchange)
    : setup_(setup),
      exchange_(exchange),
      inputs_(ports_of(setup.package->description(), Causality::input)),
      continuous_inputs_(ports_of(setup.package->description(), Causality::input),
                         ValueGroups::Which::continuous),
      outputs_(ports_of(setup.package->description(), Causality::output)),
      discrete_(discrete_numbers(setup.package->description())),
      signs_(exchange.counts.indicators) {
  last_.resize(discrete_.size());
}

Model::~Model() {
  leave();
}

void Model::leave() {
  if (calls_) --setup_.package->instances();
  calls_.reset();
}

void Model::enter() {
  const bool only_once = interface_of(setup_.package->description(), setup_.mode).only_once;
  if (setup_.package->instances()++ > 0 && only_once) {
    --setup_.package->instances();
    throw UnitError(
        "a process may have but one instance of the unit, and has one; with isolate: true each has a "
        "process");
  }
  try {
    calls_ = instantiate(*setup_.package, setup_.mode, setup_.name, exchange_.call);
  } catch (...) {
    --setup_.package->instances();
    throw;
  }
}

void Model::fail(const std::string& message) {
  exchange_.ok = 0;
  const std::size_t length = std::min(message.size(), sizeof exchange_.message - 1);
  std::memcpy(exchange_.message, message.data(), length);
  exchange_.message[length] = '\0';
}

void Model::run() {
  exchange_.ok = 1;
  try {
    if (exchange_.operation == Operation::start)
      start();
    else if (!perform())
      fail(calls_->message());
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail(exchange_.call.text() + " threw an exception");
  }
}

void Model::start() {
  leave();
  enter();
  if (!assign() || !calls_->set_up(exchange_.time) || !assign() || !calls_->initialize() || !begin())
    return fail(calls_->message());
  const Interface& about = interface_of(setup_.package->description(), setup_.mode);
  exchange_.state_bytes = about.keeps_state ? calls_->state_size() : 0;
  if (exchange_.state_bytes > most_state_bytes)
    throw UnitError(fmt::format("its state has {} bytes, and at most {} can be saved", exchange_.state_bytes,
                                most_state_bytes));
  exchange_.kept_numbers =
      exchange_.state_bytes == 0 ? 0 : (exchange_.state_bytes + 7) / 8 + 1 + signs_.size() + last_.size();
  if (!save()) fail(calls_->message());
}

bool Model::assign() {
  return std::ranges::all_of(setup_.assignments, [&](const Assignment& assignment) {
    return ValueGroups({assignment.variable}).set(*calls_, assignment.numbers.data());
  });
}

bool Model::begin() {
  exchange_.next = never;
  reached_ = -never;
  exchange_.changed = exchange_.ended = 0;
  if (!inputs_.get(*calls_, exchange_.inputs())) return false;
  for (std::size_t i = 0; i < discrete_.size(); ++i) last_[i] = exchange_.inputs()[discrete_[i]];
  if (setup_.mode == Mode::model_exchange) {
    if (!iterate_events() || !calls_->get_states(exchange_.states(), exchange_.counts.states)) return false;
  }
  return outputs_.get(*calls_, exchange_.outputs());
}

/// Iterates the event mode until the unit needs no further update, then enters continuous-time mode.
bool Model::iterate_events() {
  EventInfo info{.again = true};
  for (int i = 0; info.again; ++i) {
    info = {};
    if (i == most_iterations) throw UnitError("its events do not come to an end");
    if (!calls_->update(info)) return false;
    exchange_.changed |= info.states_changed ? 1u : 0u;
    exchange_.ended |= info.terminates ? 1u : 0u;
    if (info.terminates) return true;
  }
  require_next(info);
  exchange_.next = info.has_next ? info.next : never;
  if (!calls_->leave_event()) return false;
  if (exchange_.counts.indicators == 0) return true;
  if (!read_indicators()) return false;
  for (std::size_t i = 0; i < signs_.size(); ++i) signs_[i] = exchange_.indicators()[i] > 0.0;
  return true;
}

void Model::require_next(const EventInfo& info) const {
  if (!info.has_next ||
      (std::isfinite(info.next) && info.next >= exchange_.time - tolerance_at(exchange_.time)))
    return;
  throw UnitError(
      fmt::format("it returned {} s as the time of its next event, at {} s; that must be a later time",
                  info.next, exchange_.time));
}

bool Model::read_indicators() {
  const double* first = exchange_.indicators();
  if (!calls_->get_indicators(exchange_.indicators(), signs_.size())) return false;
  const double* wrong =
      std::find_if_not(first, first + signs_.size(), [](double z) { return std::isfinite(z); });
  if (wrong == first + signs_.size()) return true;
  throw UnitError(fmt::format("its event indicator {} is {} at {} s; it must be a finite number",
                              wrong - first + 1, *wrong, exchange_.time));
}

bool Model::move_to(double time) {
  return calls_->set_time(time) &&
         (exchange_.counts.states == 0 || calls_->set_states(exchange_.states(), exchange_.counts.states)) &&
         continuous_inputs_.set(*calls_, exchange_.inputs());
}

bool Model::act() {
  exchange_.changed = exchange_.ended = 0;
  StepInfo info;
  if (!move_to(exchange_.time) || !calls_->complete_step(info)) return false;
  if (info.terminates) return end();
  bool due = info.enters_event || exchange_.time >= exchange_.next - 1e-9 * std::abs(exchange_.next);
  if (!signs_.empty()) {
    if (!read_indicators()) return false;
    for (std::size_t i = 0; i < signs_.size(); ++i)
      due |= (exchange_.indicators()[i] > 0.0) != bool(signs_[i]);
  }
  for (std::size_t i = 0; i < discrete_.size(); ++i) {
    const double now = exchange_.inputs()[discrete_[i]];
    due |= now != last_[i];
    last_[i] = now;
  }
  if (!due) return true;
  if (!calls_->enter_event() || !inputs_.set(*calls_, exchange_.inputs()) || !iterate_events()) return false;
  if (exchange_.ended && !end()) return false;
  return !exchange_.changed || calls_->get_states(exchange_.states(), exchange_.counts.states);
}

/// Reads the final outputs of a unit that has ended; it is not called afterwards.
bool Model::end() {
  exchange_.ended = 1;
  return outputs_.get(*calls_, exchange_.outputs());
}

bool Model::step() {
  exchange_.ended = 0;
  StepInfo info;
  if (!inputs_.set(*calls_, exchange_.inputs())) return false;
  if (!calls_->step(exchange_.time, exchange_.length, info)) return false;
  require_reached(info.reached);
  exchange_.reached = info.reached;
  if (info.terminates) exchange_.ended = info.made ? 1 : 2;
  return outputs_.get(*calls_, exchange_.outputs());
}

/// Throws UnitError for an invalid last successful time. A unit with internal steps may stop before the end
/// of the step; it may not go backwards. FMI does not allow to pass the end. Units whose internal steps do
/// not divide the step pass it by a part of one, and other importers take them; so this is no failure.
void Model::require_reached(double reached) {
  const Description& about = setup_.package->description();
  const double end = exchange_.time + exchange_.length, tolerance = tolerance_at(end);
  const double most = end + std::max(tolerance, interface_of(about, setup_.mode).internal_step);
  if (std::isfinite(reached) && reached >= reached_ - tolerance && reached <= most) {
    reached_ = reached;
    return;
  }
  throw UnitError(fmt::format(
      "it returned {} s as its last successful time, in the step from {} s to {} s; that must be a "
      "time up to there, and no earlier than before{}",
      reached, exchange_.time, end,
      about.model_exchange.identifier.empty() ? "" : "; write 'interface: model_exchange'"));
}

// Saves the bytes of the unit, followed by the numbers of its events. The saved state of a unit that has
// ended is the one before its end.
bool Model::save() {
  if (exchange_.counts.kept == 0 || exchange_.state_bytes == 0 || exchange_.ended) return true;
  if (exchange_.kept_numbers > exchange_.counts.kept)
    throw UnitError("its state takes more bytes than that of the instance before");
  double* behind = exchange_.kept() + (exchange_.state_bytes + 7) / 8;
  if (!calls_->save(reinterpret_cast<char*>(exchange_.kept()), exchange_.state_bytes)) return false;
  *behind++ = exchange_.next;
  behind = std::ranges::copy(signs_, behind).out;
  std::ranges::copy(last_, behind);
  return true;
}

bool Model::load() {
  const double* behind = exchange_.kept() + (exchange_.state_bytes + 7) / 8;
  exchange_.ended = 0;
  reached_ = -never;
  exchange_.next = *behind++;
  for (char& sign : signs_) sign = *behind++ != 0.0;
  for (double& number : last_) number = *behind++;
  return calls_->load(reinterpret_cast<const char*>(exchange_.kept()), exchange_.state_bytes);
}

bool Model::perform() {
  switch (exchange_.operation) {
    case Operation::outputs:
      return move_to(exchange_.time) && outputs_.get(*calls_, exchange_.outputs());
    case Operation::slopes:
      return move_to(exchange_.time) && calls_->get_slopes(exchange_.slopes(), exchange_.counts.states);
    case Operation::crossings:
      return move_to(exchange_.time) && (signs_.empty() || read_indicators());
    case Operation::act:
      return act() && save();
    case Operation::step:
      return step() && save();
    case Operation::load:
      return load();
    default:
      return true;
  }
}

}  // namespace stepwire::fmi
