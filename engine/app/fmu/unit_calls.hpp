#pragma once

// Parts of the functions of an exported unit that are the same in both versions of FMI.

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include "engine/app/fmu/exported_unit.hpp"

namespace stepwire::fmu {

/// Instance as its callers have it. `Version` has the type Status of an FMI version and log(status, message).
/// It also names the type of numbers, and has the message for a wrong token.
template <class Version>
struct Instance {
  using Result = typename Version::Status;

  Version caller;
  std::unique_ptr<ExportedUnit> unit{};
  StepEnd end{};  ///< end of the last step

  /// Returns a new instance. If that fails, or `why_not` is a reason against it, logs the reason and returns
  /// nullptr.
  static Instance* make(const Version& caller, const char* token, bool exchange, const char* why_not) {
    std::unique_ptr<Instance> own(new (std::nothrow) Instance{caller});
    if (!own) return nullptr;
    if (!why_not && !(token && std::strcmp(token, unit_source.token) == 0)) why_not = Version::wrong_token;
    if (!why_not && exchange) why_not = unit_source.no_exchange;
    if (!why_not) own->unit.reset(unit_source.make(exchange, own.get(), log));
    if (!why_not && !own->unit) why_not = "there is no memory for an instance";
    if (why_not) log(own.get(), Status::error, why_not);
    return why_not ? nullptr : own.release();
  }

  static Instance& of(void* instance) { return *static_cast<Instance*>(instance); }
  static void log(void* instance, Status status, const char* message) {
    of(instance).caller.log(static_cast<Result>(status), message);
  }

  /// Returns the status of `work`, a function of the unit and of the end of its last step. An error without
  /// an instance.
  template <class Work>
  static Result call(void* instance, const Work& work) {
    return static_cast<Result>(instance ? work(*of(instance).unit, of(instance).end) : Status::error);
  }

  /// Refuses values of a type that no variable has.
  static Status none(ExportedUnit& unit, std::size_t count, const char* type) {
    if (count == 0) return Status::ok;
    return unit.refuse("it has no variables of the type %s, only %s", type, Version::number);
  }
};

/// Sets *state to memory for a state of the unit if it is nullptr. False if memory allocation failed.
inline bool has_memory(ExportedUnit& unit, void** state) {
  if (!*state) *state = std::malloc(unit.state_bytes());
  return *state || unit.refuse("there is no memory for a state") == Status::ok;
}

inline Status save_state(ExportedUnit& unit, void** state) {
  if (!unit.given("GetFMUState", {{"FMUState", state}}) || !has_memory(unit, state)) return Status::error;
  unit.save(*state);
  return Status::ok;
}

inline Status load_state(ExportedUnit& unit, const void* state) {
  return unit.given("SetFMUState", {{"FMUState", state}}) ? unit.load(state) : Status::error;
}

inline Status free_state(void** state) {
  if (!state) return Status::ok;
  std::free(*state);
  *state = nullptr;
  return Status::ok;
}

inline Status write_state(ExportedUnit& unit, const void* state, void* bytes, std::size_t size) {
  if (!unit.given("SerializeFMUState", {{"FMUState", state}, {"serializedState", bytes, size}}))
    return Status::error;
  if (size < unit.state_bytes())
    return unit.refuse("a state takes %zu bytes, not %zu", unit.state_bytes(), size);
  std::memcpy(bytes, state, unit.state_bytes());
  return Status::ok;
}

inline Status read_state(ExportedUnit& unit, const void* bytes, std::size_t size, void** state) {
  const bool given =
      unit.given("DeserializeFMUState", {{"serializedState", bytes, size}, {"FMUState", state}});
  if (!given || unit.check_state(bytes, size) != Status::ok || !has_memory(unit, state)) return Status::error;
  std::memcpy(*state, bytes, size);
  return Status::ok;
}

/// Writes the result of a call, for which `call` has to have a place with a name of the standard.
template <class Place, class Value>
Status tell(ExportedUnit& unit, const char* call, const char* name, Place* place, Value value) {
  if (!unit.given(call, {{name, place}})) return Status::error;
  *place = value;
  return Status::ok;
}

}  // namespace stepwire::fmu
