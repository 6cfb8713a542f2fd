#pragma once

// FMI 3 functions of an exported unit. Only the single source of the unit includes this file.

#include <cmath>
#include <memory>
#include <new>

#include "engine/app/fmu/unit_calls.hpp"
#include "engine/base/fmi/fmi3_unit.h"

namespace stepwire::fmu {

/// Instance as FMI 3 callers have it.
struct InstanceOf3 {
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;
  std::unique_ptr<ExportedUnit> unit{};

  static void say(void* own, Status status, const char* message) {
    const auto& instance = *static_cast<InstanceOf3*>(own);
    if (instance.log)
      instance.log(instance.environment, static_cast<fmi3Status>(status), "logStatusError", message);
  }
};

/// Calls `work` with the unit and returns its status; an error for a null instance.
template <class Work>
fmi3Status with_unit_of_3(fmi3Instance instance, const Work& work) {
  if (!instance) return fmi3Error;
  return static_cast<fmi3Status>(work(*static_cast<InstanceOf3*>(instance)->unit));
}

inline fmi3Instance make_of_3(bool exchange, fmi3String token, fmi3InstanceEnvironment environment,
                              fmi3LogMessageCallback log, const char* why_not) {
  std::unique_ptr<InstanceOf3> own(new (std::nothrow) InstanceOf3{environment, log});
  if (!own) return nullptr;
  if (!why_not && !is_token(token)) why_not = "the instantiation token is not that of this unit";
  return make_unit(own->unit, own.get(), InstanceOf3::say, exchange, why_not) ? nullptr : own.release();
}

/// Refuses values of a type that no variable has.
inline fmi3Status none_of_3(fmi3Instance instance, size_t count, const char* type) {
  return with_unit_of_3(instance,
                        [&](ExportedUnit& unit) { return refuse_values(unit, count, type, "Float64"); });
}

inline fmi3Status refuse_of_3(fmi3Instance instance, const char* what) {
  return with_unit_of_3(instance, [&](ExportedUnit& unit) { return unit.refuse("it has no %s", what); });
}

}  // namespace stepwire::fmu

namespace unit_functions = stepwire::fmu;

extern "C" {

const char* fmi3GetVersion(void) {
  return "3.0";
}
fmi3Status fmi3SetDebugLogging(fmi3Instance unit, fmi3Boolean, size_t, const fmi3String[]) {
  return unit ? fmi3OK : fmi3Error;
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  return unit_functions::make_of_3(true, token, environment, log, nullptr);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean event_mode, fmi3Boolean, const fmi3ValueReference[],
                                         size_t intermediate_count, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback) {
  const char* why_not = event_mode               ? "its co-simulation has no event mode"
                        : intermediate_count > 0 ? "it has no intermediate variables"
                                                 : nullptr;
  return unit_functions::make_of_3(false, token, environment, log, why_not);
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String token, fmi3String, fmi3Boolean,
                                               fmi3Boolean, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  return unit_functions::make_of_3(false, token, environment, log, "it has no scheduled execution");
}
void fmi3FreeInstance(fmi3Instance unit) {
  delete static_cast<unit_functions::InstanceOf3*>(unit);
}

// Body of a function below, which uses the function's own argument names: evaluates the expression with
// `own`, the unit.
#define STEPWIRE_DOES(...)                                                                                 \
  {                                                                                                        \
    return unit_functions::with_unit_of_3(unit,                                                            \
                                          [&](unit_functions::ExportedUnit& own) { return __VA_ARGS__; }); \
  }

fmi3Status fmi3EnterInitializationMode(fmi3Instance unit, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                       fmi3Boolean, fmi3Float64)
    STEPWIRE_DOES(own.enter_initialization(start)) fmi3Status fmi3ExitInitializationMode(fmi3Instance unit)
        STEPWIRE_DOES(own.leave_initialization()) fmi3Status fmi3Terminate(fmi3Instance unit)
            STEPWIRE_DOES(own.terminate()) fmi3Status fmi3Reset(fmi3Instance unit)
                STEPWIRE_DOES(own.reset()) fmi3Status fmi3EnterConfigurationMode(fmi3Instance unit) {
  return unit_functions::refuse_of_3(unit, "structural parameters");
}
fmi3Status fmi3ExitConfigurationMode(fmi3Instance unit) {
  return unit_functions::refuse_of_3(unit, "structural parameters");
}
fmi3Status fmi3EnterStepMode(fmi3Instance unit) {
  return unit_functions::refuse_of_3(unit, "event mode in its co-simulation");
}

fmi3Status fmi3GetFloat64(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                          fmi3Float64 values[], size_t numbers)
    STEPWIRE_DOES(own.get({references, count}, values, numbers)) fmi3Status
    fmi3SetFloat64(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                   const fmi3Float64 values[],
                   size_t numbers) STEPWIRE_DOES(own.set({references, count}, values, numbers))
#define STEPWIRE_NONE_OF(Type)                                                                              \
  fmi3Status fmi3Get##Type(fmi3Instance unit, const fmi3ValueReference[], size_t count, fmi3##Type[],       \
                           size_t) {                                                                        \
    return unit_functions::none_of_3(unit, count, #Type);                                                   \
  }                                                                                                         \
  fmi3Status fmi3Set##Type(fmi3Instance unit, const fmi3ValueReference[], size_t count, const fmi3##Type[], \
                           size_t) {                                                                        \
    return unit_functions::none_of_3(unit, count, #Type);                                                   \
  }
        STEPWIRE_NONE_OF(Float32) STEPWIRE_NONE_OF(Int8) STEPWIRE_NONE_OF(UInt8) STEPWIRE_NONE_OF(Int16)
            STEPWIRE_NONE_OF(UInt16) STEPWIRE_NONE_OF(Int32) STEPWIRE_NONE_OF(UInt32) STEPWIRE_NONE_OF(Int64)
                STEPWIRE_NONE_OF(UInt64) STEPWIRE_NONE_OF(Boolean) STEPWIRE_NONE_OF(String)
#undef STEPWIRE_NONE_OF
                    fmi3Status fmi3GetBinary(fmi3Instance unit, const fmi3ValueReference[], size_t count,
                                             size_t[], fmi3Binary[], size_t) {
  return unit_functions::none_of_3(unit, count, "Binary");
}
fmi3Status fmi3SetBinary(fmi3Instance unit, const fmi3ValueReference[], size_t count, const size_t[],
                         const fmi3Binary[], size_t) {
  return unit_functions::none_of_3(unit, count, "Binary");
}
fmi3Status fmi3GetClock(fmi3Instance unit, const fmi3ValueReference[], size_t count, fmi3Clock[]) {
  return unit_functions::none_of_3(unit, count, "Clock");
}
fmi3Status fmi3SetClock(fmi3Instance unit, const fmi3ValueReference[], size_t count, const fmi3Clock[]) {
  return unit_functions::none_of_3(unit, count, "Clock");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance unit, fmi3ValueReference, size_t*) {
  return unit_functions::refuse_of_3(unit, "dependencies of single elements");
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance unit, fmi3ValueReference, size_t[], fmi3ValueReference[],
                                       size_t[], fmi3DependencyKind[], size_t) {
  return unit_functions::refuse_of_3(unit, "dependencies of single elements");
}
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance unit, const fmi3ValueReference unknowns[],
                                        size_t unknown_count, const fmi3ValueReference knowns[],
                                        size_t known_count, const fmi3Float64 seed[], size_t seeds,
                                        fmi3Float64 sensitivity[], size_t sensitivities)
    STEPWIRE_DOES(own.numbers_of({unknowns, unknown_count}) != static_cast<std::ptrdiff_t>(sensitivities) ||
                          own.numbers_of({knowns, known_count}) != static_cast<std::ptrdiff_t>(seeds)
                      ? own.refuse("seeds or sensitivities are not as many as the numbers of their variables")
                      : own.derivative({unknowns, unknown_count}, {knowns, known_count}, seed,
                                       sensitivity)) fmi3Status
    fmi3GetAdjointDerivative(fmi3Instance unit, const fmi3ValueReference[], size_t,
                             const fmi3ValueReference[], size_t, const fmi3Float64[], size_t, fmi3Float64[],
                             size_t) {
  return unit_functions::refuse_of_3(unit, "adjoint derivatives");
}

fmi3Status fmi3GetFMUState(fmi3Instance unit, fmi3FMUState* state)
    STEPWIRE_DOES(unit_functions::save_state(own, state)) fmi3Status
    fmi3SetFMUState(fmi3Instance unit, fmi3FMUState state)
        STEPWIRE_DOES(unit_functions::load_state(own, state)) fmi3Status
    fmi3FreeFMUState(fmi3Instance unit, fmi3FMUState* state) {
  if (!unit) return fmi3Error;
  unit_functions::free_state(state);
  return fmi3OK;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance unit, fmi3FMUState, size_t* size)
    STEPWIRE_DOES(*size = own.state_bytes(), unit_functions::Status::ok) fmi3Status
    fmi3SerializeFMUState(fmi3Instance unit, fmi3FMUState state, fmi3Byte bytes[], size_t size)
        STEPWIRE_DOES(unit_functions::write_state(own, state, bytes, size)) fmi3Status
    fmi3DeserializeFMUState(fmi3Instance unit, const fmi3Byte bytes[], size_t size, fmi3FMUState* state)
        STEPWIRE_DOES(unit_functions::read_state(own, bytes, size, state))

            fmi3Status fmi3GetIntervalDecimal(fmi3Instance unit, const fmi3ValueReference[], size_t,
                                              fmi3Float64[], fmi3IntervalQualifier[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3GetIntervalFraction(fmi3Instance unit, const fmi3ValueReference[], size_t, fmi3UInt64[],
                                   fmi3UInt64[], fmi3IntervalQualifier[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3GetShiftDecimal(fmi3Instance unit, const fmi3ValueReference[], size_t, fmi3Float64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3GetShiftFraction(fmi3Instance unit, const fmi3ValueReference[], size_t, fmi3UInt64[],
                                fmi3UInt64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3SetIntervalDecimal(fmi3Instance unit, const fmi3ValueReference[], size_t,
                                  const fmi3Float64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3SetIntervalFraction(fmi3Instance unit, const fmi3ValueReference[], size_t, const fmi3UInt64[],
                                   const fmi3UInt64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3SetShiftDecimal(fmi3Instance unit, const fmi3ValueReference[], size_t, const fmi3Float64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3SetShiftFraction(fmi3Instance unit, const fmi3ValueReference[], size_t, const fmi3UInt64[],
                                const fmi3UInt64[]) {
  return unit_functions::refuse_of_3(unit, "clocks");
}
fmi3Status fmi3ActivateModelPartition(fmi3Instance unit, fmi3ValueReference, fmi3Float64) {
  return unit_functions::refuse_of_3(unit, "clocks");
}

fmi3Status fmi3SetTime(fmi3Instance unit, fmi3Float64 time) STEPWIRE_DOES(own.set_time(time)) fmi3Status
    fmi3SetContinuousStates(fmi3Instance unit, const fmi3Float64 states[], size_t count)
        STEPWIRE_DOES(own.set_states(states, count)) fmi3Status
    fmi3GetContinuousStates(fmi3Instance unit, fmi3Float64 states[], size_t count)
        STEPWIRE_DOES(own.get_states(states, count)) fmi3Status
    fmi3GetContinuousStateDerivatives(fmi3Instance unit, fmi3Float64 derivatives[], size_t count)
        STEPWIRE_DOES(own.get_slopes(derivatives, count)) fmi3Status
    fmi3GetEventIndicators(fmi3Instance unit, fmi3Float64 indicators[], size_t count)
        STEPWIRE_DOES(own.get_crossings(indicators, count)) fmi3Status
    fmi3GetNominalsOfContinuousStates(fmi3Instance unit, fmi3Float64 nominals[], size_t count)
        STEPWIRE_DOES([&] {
          for (size_t i = 0; i < count; ++i) nominals[i] = 1.0;
          return unit_functions::Status::ok;
        }()) fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance unit, size_t* count)
            STEPWIRE_DOES(*count = own.crossing_count(), unit_functions::Status::ok) fmi3Status
    fmi3GetNumberOfContinuousStates(fmi3Instance unit, size_t* count)
        STEPWIRE_DOES(*count = own.state_count(), unit_functions::Status::ok) fmi3Status
    fmi3CompletedIntegratorStep(fmi3Instance unit, fmi3Boolean, fmi3Boolean* enter_event,
                                fmi3Boolean* terminate)
        STEPWIRE_DOES(*enter_event = false, own.complete_step(*terminate)) fmi3Status
    fmi3EnterEventMode(fmi3Instance unit) STEPWIRE_DOES(own.enter_event()) fmi3Status
    fmi3EvaluateDiscreteStates(fmi3Instance unit) {
  return unit ? fmi3OK : fmi3Error;
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance unit, fmi3Boolean* again, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_defined, fmi3Float64* next) STEPWIRE_DOES([&] {
  *again = *nominals_changed = *states_changed = false;
  const unit_functions::Status status = own.update(*terminate, *next);
  *next_defined = std::isfinite(*next);
  return status;
}()) fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance unit) STEPWIRE_DOES(own.leave_event())

    fmi3Status fmi3GetOutputDerivatives(fmi3Instance unit, const fmi3ValueReference[], size_t,
                                        const fmi3Int32[], fmi3Float64[], size_t) {
  return unit_functions::refuse_of_3(unit, "derivatives of outputs by the time");
}
fmi3Status fmi3DoStep(fmi3Instance unit, fmi3Float64 time, fmi3Float64 length, fmi3Boolean,
                      fmi3Boolean* event, fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last)
    STEPWIRE_DOES([&] {
      unit_functions::StepEnd end;
      const unit_functions::Status status = own.step(time, length, end);
      *event = false;
      *terminate = end.terminates;
      *early = !end.whole;
      *last = end.last;
      return status;
    }())

#undef STEPWIRE_DOES

}  // extern "C"
