#pragma once

// Parts of the FMI functions that are the same in both versions.

#include <cstdlib>
#include <cstring>
#include <memory>

#include "engine/app/fmu/exported_unit.hpp"

namespace stepwire::fmu {

/// Makes the unit of an instance. Returns the reason of a failure, which is also logged, or nullptr.
inline const char* make_unit(std::unique_ptr<ExportedUnit>& unit, void* caller, ExportedUnit::Log log,
                             bool exchange, const char* why_not) {
  if (!why_not && exchange) why_not = unit_source.no_exchange;
  if (!why_not) unit.reset(unit_source.make(exchange, caller, log));
  if (!why_not && !unit) why_not = "there is no memory for an instance";
  if (why_not) log(caller, Status::error, why_not);
  return why_not;
}

inline bool is_token(const char* token) {
  return token && std::strcmp(token, unit_source.token) == 0;
}

/// Refuses values of a type that no variable has.
inline Status refuse_values(ExportedUnit& unit, std::size_t count, const char* type, const char* known) {
  return count == 0 ? Status::ok : unit.refuse("it has no variables of the type %s, only %s", type, known);
}

/// Saves the state; allocates its memory if *state is nullptr.
inline Status save_state(ExportedUnit& unit, void** state) {
  if (!state) return unit.refuse("there is no place for a state");
  if (!*state) *state = std::malloc(unit.state_bytes());
  if (!*state) return unit.refuse("there is no memory for a state");
  unit.save(*state);
  return Status::ok;
}

inline Status load_state(ExportedUnit& unit, const void* state) {
  return state ? unit.load(state) : unit.refuse("there is no state to be set");
}

inline void free_state(void** state) {
  if (!state) return;
  std::free(*state);
  *state = nullptr;
}

inline Status write_state(ExportedUnit& unit, const void* state, void* bytes, std::size_t size) {
  if (!state || size < unit.state_bytes())
    return unit.refuse("a state takes %zu bytes, not %zu", unit.state_bytes(), size);
  std::memcpy(bytes, state, unit.state_bytes());
  return Status::ok;
}

inline Status read_state(ExportedUnit& unit, const void* bytes, std::size_t size, void** state) {
  if (unit.check_state(bytes, size) != Status::ok) return Status::error;
  if (!*state) *state = std::malloc(size);
  if (!*state) return unit.refuse("there is no memory for a state");
  std::memcpy(*state, bytes, size);
  return Status::ok;
}

}  // namespace stepwire::fmu
