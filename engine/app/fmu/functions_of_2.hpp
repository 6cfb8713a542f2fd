#pragma once

// FMI 2 functions of an exported unit. Only the single source of the unit includes this file.

#include <cmath>
#include <memory>
#include <new>
#include <string>

#include "engine/app/fmu/unit_calls.hpp"
#include "engine/base/fmi/fmi2_unit.h"

namespace stepwire::fmu {

/// Instance as FMI 2 callers have it.
struct InstanceOf2 {
  std::string name;
  fmi2CallbackLogger log;
  fmi2ComponentEnvironment environment;
  std::unique_ptr<ExportedUnit> unit{};
  StepEnd end{};  ///< end of the last step

  static void say(void* own, Status status, const char* message) {
    const auto& instance = *static_cast<InstanceOf2*>(own);
    if (instance.log)
      instance.log(instance.environment, instance.name.c_str(), static_cast<fmi2Status>(status),
                   "logStatusError", "%s", message);
  }
};

inline InstanceOf2& instance_of_2(fmi2Component unit) {
  return *static_cast<InstanceOf2*>(unit);
}

/// Calls `work` with the unit and returns its status; an error for a null instance.
template <class Work>
fmi2Status with_unit_of_2(fmi2Component instance, const Work& work) {
  if (!instance) return fmi2Error;
  return static_cast<fmi2Status>(work(*instance_of_2(instance).unit));
}

inline fmi2Component make_of_2(fmi2String name, bool exchange, fmi2String token,
                               const fmi2CallbackFunctions* functions) {
  std::unique_ptr<InstanceOf2> own(new (std::nothrow)
                                       InstanceOf2{name ? name : "", functions ? functions->logger : nullptr,
                                                   functions ? functions->componentEnvironment : nullptr});
  if (!own) return nullptr;
  const char* why_not = is_token(token) ? nullptr : "the GUID is not that of this unit";
  return make_unit(own->unit, own.get(), InstanceOf2::say, exchange, why_not) ? nullptr : own.release();
}

/// Refuses values of a type that no variable has.
inline fmi2Status none_of_2(fmi2Component instance, size_t count, const char* type) {
  return with_unit_of_2(instance,
                        [&](ExportedUnit& unit) { return refuse_values(unit, count, type, "Real"); });
}

inline fmi2Status refuse_of_2(fmi2Component instance, const char* what) {
  return with_unit_of_2(instance, [&](ExportedUnit& unit) { return unit.refuse("it has no %s", what); });
}

}  // namespace stepwire::fmu

namespace unit_functions = stepwire::fmu;

extern "C" {

const char* fmi2GetVersion(void) {
  return "2.0";
}
const char* fmi2GetTypesPlatform(void) {
  return "default";
}
fmi2Status fmi2SetDebugLogging(fmi2Component unit, fmi2Boolean, size_t, const fmi2String[]) {
  return unit ? fmi2OK : fmi2Error;
}
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean) {
  return unit_functions::make_of_2(name, type == fmi2ModelExchange, guid, functions);
}
void fmi2FreeInstance(fmi2Component unit) {
  delete static_cast<unit_functions::InstanceOf2*>(unit);
}

// Body of a function below, which uses the function's own argument names: evaluates the expression with
// `own`, the unit.
#define STEPWIRE_DOES(...)                                                                                 \
  {                                                                                                        \
    return unit_functions::with_unit_of_2(unit,                                                            \
                                          [&](unit_functions::ExportedUnit& own) { return __VA_ARGS__; }); \
  }

// Keeps the start time for the initialization.
fmi2Status fmi2SetupExperiment(fmi2Component unit, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean,
                               fmi2Real)
    STEPWIRE_DOES(own.allows(0u | unit_functions::Phase::made, "SetupExperiment")
                      ? (unit_functions::instance_of_2(unit).end.last = start, unit_functions::Status::ok)
                      : unit_functions::Status::error) fmi2Status
    fmi2EnterInitializationMode(fmi2Component unit)
        STEPWIRE_DOES(own.enter_initialization(unit_functions::instance_of_2(unit).end.last)) fmi2Status
    fmi2ExitInitializationMode(fmi2Component unit) STEPWIRE_DOES(own.leave_initialization()) fmi2Status
    fmi2Terminate(fmi2Component unit) STEPWIRE_DOES(own.terminate()) fmi2Status fmi2Reset(fmi2Component unit)
        STEPWIRE_DOES(unit_functions::instance_of_2(unit).end = {}, own.reset())

            fmi2Status
    fmi2GetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count, fmi2Real values[])
        STEPWIRE_DOES(own.get({references, count}, values, count)) fmi2Status
    fmi2SetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                const fmi2Real values[]) STEPWIRE_DOES(own.set({references, count}, values, count))
#define STEPWIRE_NONE_OF(Type)                                                                           \
  fmi2Status fmi2Get##Type(fmi2Component unit, const fmi2ValueReference[], size_t count, fmi2##Type[]) { \
    return unit_functions::none_of_2(unit, count, #Type);                                                \
  }                                                                                                      \
  fmi2Status fmi2Set##Type(fmi2Component unit, const fmi2ValueReference[], size_t count,                 \
                           const fmi2##Type[]) {                                                         \
    return unit_functions::none_of_2(unit, count, #Type);                                                \
  }
        STEPWIRE_NONE_OF(Integer) STEPWIRE_NONE_OF(Boolean) STEPWIRE_NONE_OF(String)
#undef STEPWIRE_NONE_OF

            fmi2Status
    fmi2GetDirectionalDerivative(fmi2Component unit, const fmi2ValueReference unknowns[],
                                 size_t unknown_count, const fmi2ValueReference knowns[], size_t known_count,
                                 const fmi2Real seed[], fmi2Real sensitivity[])
        STEPWIRE_DOES(own.derivative({unknowns, unknown_count}, {knowns, known_count}, seed, sensitivity))

            fmi2Status fmi2GetFMUstate(fmi2Component unit, fmi2FMUstate* state)
                STEPWIRE_DOES(unit_functions::save_state(own, state)) fmi2Status
    fmi2SetFMUstate(fmi2Component unit, fmi2FMUstate state)
        STEPWIRE_DOES(unit_functions::load_state(own, state)) fmi2Status
    fmi2FreeFMUstate(fmi2Component unit, fmi2FMUstate* state) {
  if (!unit) return fmi2Error;
  unit_functions::free_state(state);
  return fmi2OK;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component unit, fmi2FMUstate, size_t* size)
    STEPWIRE_DOES(*size = own.state_bytes(), unit_functions::Status::ok) fmi2Status
    fmi2SerializeFMUstate(fmi2Component unit, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
        STEPWIRE_DOES(unit_functions::write_state(own, state, bytes, size)) fmi2Status
    fmi2DeSerializeFMUstate(fmi2Component unit, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state)
        STEPWIRE_DOES(unit_functions::read_state(own, bytes, size, state))

            fmi2Status fmi2SetTime(fmi2Component unit, fmi2Real time)
                STEPWIRE_DOES(own.set_time(time)) fmi2Status
    fmi2SetContinuousStates(fmi2Component unit, const fmi2Real states[], size_t count)
        STEPWIRE_DOES(own.set_states(states, count)) fmi2Status
    fmi2GetContinuousStates(fmi2Component unit, fmi2Real states[], size_t count)
        STEPWIRE_DOES(own.get_states(states, count)) fmi2Status
    fmi2GetDerivatives(fmi2Component unit, fmi2Real derivatives[], size_t count)
        STEPWIRE_DOES(own.get_slopes(derivatives, count)) fmi2Status
    fmi2GetEventIndicators(fmi2Component unit, fmi2Real indicators[], size_t count)
        STEPWIRE_DOES(own.get_crossings(indicators, count)) fmi2Status
    fmi2GetNominalsOfContinuousStates(fmi2Component unit, fmi2Real nominals[], size_t count)
        STEPWIRE_DOES([&] {
          for (size_t i = 0; i < count; ++i) nominals[i] = 1.0;
          return unit_functions::Status::ok;
        }()) fmi2Status fmi2CompletedIntegratorStep(fmi2Component unit, fmi2Boolean, fmi2Boolean* enter_event,
                                                    fmi2Boolean* terminate) STEPWIRE_DOES([&] {
          bool terminates = false;
          const unit_functions::Status status = own.complete_step(terminates);
          *enter_event = fmi2False;
          *terminate = terminates ? fmi2True : fmi2False;
          return status;
        }()) fmi2Status fmi2EnterEventMode(fmi2Component unit) STEPWIRE_DOES(own.enter_event()) fmi2Status
    fmi2NewDiscreteStates(fmi2Component unit, fmi2EventInfo* info) STEPWIRE_DOES([&] {
      bool terminates = false;
      double next = 0.0;
      const unit_functions::Status status = own.update(terminates, next);
      *info = {fmi2False, terminates ? fmi2True : fmi2False,          fmi2False,
               fmi2False, std::isfinite(next) ? fmi2True : fmi2False, next};
      return status;
    }()) fmi2Status fmi2EnterContinuousTimeMode(fmi2Component unit) STEPWIRE_DOES(own.leave_event())

        fmi2Status fmi2SetRealInputDerivatives(fmi2Component unit, const fmi2ValueReference[], size_t,
                                               const fmi2Integer[], const fmi2Real[]) {
  return unit_functions::refuse_of_2(unit, "interpolation of inputs");
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component unit, const fmi2ValueReference[], size_t,
                                        const fmi2Integer[], fmi2Real[]) {
  return unit_functions::refuse_of_2(unit, "derivatives of outputs by the time");
}
fmi2Status fmi2CancelStep(fmi2Component unit) {
  return unit_functions::refuse_of_2(unit, "steps that go on in the background");
}

// A step that ended early returns fmi2Discard; the caller reads the reached time by fmi2GetRealStatus.
fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real time, fmi2Real length, fmi2Boolean) STEPWIRE_DOES([&] {
  unit_functions::StepEnd& end = unit_functions::instance_of_2(unit).end;
  const unit_functions::Status status = own.step(time, length, end);
  return status == unit_functions::Status::ok && !end.whole ? unit_functions::Status::discard : status;
}())

    fmi2Status fmi2GetStatus(fmi2Component unit, const fmi2StatusKind, fmi2Status* value) {
  if (value) *value = fmi2OK;
  return unit ? fmi2OK : fmi2Error;
}
fmi2Status fmi2GetRealStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return unit_functions::refuse_of_2(unit, "such a status that is real");
  if (!unit) return fmi2Error;
  *value = unit_functions::instance_of_2(unit).end.last;
  return fmi2OK;
}
fmi2Status fmi2GetIntegerStatus(fmi2Component unit, const fmi2StatusKind, fmi2Integer*) {
  return unit_functions::refuse_of_2(unit, "status that is an integer");
}
fmi2Status fmi2GetBooleanStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return unit_functions::refuse_of_2(unit, "such a status that is boolean");
  if (!unit) return fmi2Error;
  *value = unit_functions::instance_of_2(unit).end.terminates ? fmi2True : fmi2False;
  return fmi2OK;
}
fmi2Status fmi2GetStringStatus(fmi2Component unit, const fmi2StatusKind, fmi2String*) {
  return unit_functions::refuse_of_2(unit, "status that is a text");
}

#undef STEPWIRE_DOES

}  // extern "C"
