#pragma once

// FMI 3 functions of an exported unit. Only the single source of the unit includes this file.

#include "engine/app/fmu/unit_calls.hpp"
#include "engine/base/fmi/fmi3.h"

namespace stepwire::fmu {

/// FMI 3, and the arguments that its callers give to an instance.
struct Fmi3 {
  using Status = fmi3Status;
  static constexpr char number[] = "Float64";
  static constexpr char wrong_token[] = "the instantiation token is not that of this unit";

  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback logger;

  void log(Status status, const char* message) const {
    if (logger) logger(environment, status, "logStatusError", message);
  }
};

using Own = Instance<Fmi3>;
using Boolean = fmi3Boolean;
using Byte = fmi3Byte;
using Reference = fmi3ValueReference;

}  // namespace stepwire::fmu

#define STEPWIRE_FMI(name) fmi3##name
#define STEPWIRE_FMI_2_3(other, name) fmi3##name
#include "engine/app/fmu/common_functions.hpp"

namespace stepwire::fmu {

extern "C" {

const char* fmi3GetVersion(void) {
  return "3.0";
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  return Own::make({environment, log}, token, true, nullptr);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean event_mode, fmi3Boolean, const fmi3ValueReference[],
                                         size_t intermediate_count, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback) {
  const char* why_not = event_mode               ? "its co-simulation has no event mode"
                        : intermediate_count > 0 ? "it has no intermediate variables"
                                                 : nullptr;
  return Own::make({environment, log}, token, false, why_not);
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String token, fmi3String, fmi3Boolean,
                                               fmi3Boolean, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  return Own::make({environment, log}, token, false, "it has no scheduled execution");
}
STEPWIRE_DOES(fmi3EnterInitializationMode, (void* instance, bool, double, double start, bool, double),
              unit.enter_initialization(start))

STEPWIRE_DOES(fmi3GetFloat64,
              (void* instance, const Reference of[], size_t count, double values[], size_t numbers),
              unit.get({of, count}, values, numbers))
STEPWIRE_DOES(fmi3SetFloat64,
              (void* instance, const Reference of[], size_t count, const double values[], size_t numbers),
              unit.set({of, count}, values, numbers))
// A function for values of a type that no variable has: its name, the type, and the arguments after the count
// of value references.
#define STEPWIRE_NONE(name, type, ...)                                                \
  STEPWIRE_DOES(name, (void* instance, const Reference[], size_t count, __VA_ARGS__), \
                Own::none(unit, count, type))
#define STEPWIRE_NONE_OF(Type)                              \
  STEPWIRE_NONE(fmi3Get##Type, #Type, fmi3##Type[], size_t) \
  STEPWIRE_NONE(fmi3Set##Type, #Type, const fmi3##Type[], size_t)
STEPWIRE_NONE_OF(Float32)
STEPWIRE_NONE_OF(Int8)
STEPWIRE_NONE_OF(UInt8)
STEPWIRE_NONE_OF(Int16)
STEPWIRE_NONE_OF(UInt16)
STEPWIRE_NONE_OF(Int32)
STEPWIRE_NONE_OF(UInt32)
STEPWIRE_NONE_OF(Int64)
STEPWIRE_NONE_OF(UInt64)
STEPWIRE_NONE_OF(Boolean)
STEPWIRE_NONE_OF(String)
STEPWIRE_NONE(fmi3GetBinary, "Binary", size_t[], fmi3Binary[], size_t)
STEPWIRE_NONE(fmi3SetBinary, "Binary", const size_t[], const fmi3Binary[], size_t)
STEPWIRE_NONE(fmi3GetClock, "Clock", fmi3Clock[])
STEPWIRE_NONE(fmi3SetClock, "Clock", const fmi3Clock[])
#undef STEPWIRE_NONE_OF
#undef STEPWIRE_NONE
STEPWIRE_DOES(fmi3GetDirectionalDerivative,
              (void* instance, const Reference of[], size_t count, const Reference by[], size_t knowns,
               const double seed[], size_t seeds, double sensitivity[], size_t sensitivities),
              unit.derivative({of, count}, {by, knowns}, seed, seeds, sensitivity, sensitivities))

STEPWIRE_DOES(fmi3GetNumberOfEventIndicators, (void* instance, size_t* count),
              tell(unit, "GetNumberOfEventIndicators", "nEventIndicators", count, unit.crossing_count()))
STEPWIRE_DOES(fmi3GetNumberOfContinuousStates, (void* instance, size_t* count),
              tell(unit, "GetNumberOfContinuousStates", "nContinuousStates", count, unit.state_count()))
STEPWIRE_DOES(fmi3EvaluateDiscreteStates, (void* instance), Status::ok)
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* again, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_defined, fmi3Float64* next) {
  return Own::call(instance, [&](ExportedUnit& unit, StepEnd&) {
    if (!unit.given("UpdateDiscreteStates", {{"discreteStatesNeedUpdate", again},
                                             {"terminateSimulation", terminate},
                                             {"nominalsOfContinuousStatesChanged", nominals_changed},
                                             {"valuesOfContinuousStatesChanged", states_changed},
                                             {"nextEventTimeDefined", next_defined},
                                             {"nextEventTime", next}}))
      return Status::error;
    *again = *terminate = *nominals_changed = *states_changed = false;
    *next = 0.0;
    const Status status = unit.update(*terminate, *next);
    *next_defined = std::isfinite(*next);
    return status;
  });
}
fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 length, fmi3Boolean,
                      fmi3Boolean* event, fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last) {
  return Own::call(instance, [&](ExportedUnit& unit, StepEnd& end) {
    if (!unit.given("DoStep", {{"eventHandlingNeeded", event},
                               {"terminateSimulation", terminate},
                               {"earlyReturn", early},
                               {"lastSuccessfulTime", last}}))
      return Status::error;
    end = {};
    const Status status = unit.step(time, length, end);
    *event = false;
    *terminate = end.terminates;
    *early = !end.whole;
    *last = end.last;
    return status;
  });
}

STEPWIRE_LACKS("structural parameters", fmi3EnterConfigurationMode)
STEPWIRE_LACKS("structural parameters", fmi3ExitConfigurationMode)
STEPWIRE_LACKS("event mode in its co-simulation", fmi3EnterStepMode)
STEPWIRE_LACKS("dependencies of single elements", fmi3GetNumberOfVariableDependencies, Reference, size_t*)
STEPWIRE_LACKS("dependencies of single elements", fmi3GetVariableDependencies, Reference, size_t[],
               Reference[], size_t[], fmi3DependencyKind[], size_t)
STEPWIRE_LACKS("adjoint derivatives", fmi3GetAdjointDerivative, const Reference[], size_t, const Reference[],
               size_t, const double[], size_t, double[], size_t)
STEPWIRE_LACKS("derivatives of outputs by the time", fmi3GetOutputDerivatives, const Reference[], size_t,
               const fmi3Int32[], double[], size_t)
STEPWIRE_LACKS("clocks", fmi3ActivateModelPartition, Reference, double)
STEPWIRE_LACKS("clocks", fmi3GetIntervalDecimal, const Reference[], size_t, double[], fmi3IntervalQualifier[])
STEPWIRE_LACKS("clocks", fmi3GetIntervalFraction, const Reference[], size_t, fmi3UInt64[], fmi3UInt64[],
               fmi3IntervalQualifier[])
STEPWIRE_LACKS("clocks", fmi3GetShiftDecimal, const Reference[], size_t, double[])
STEPWIRE_LACKS("clocks", fmi3GetShiftFraction, const Reference[], size_t, fmi3UInt64[], fmi3UInt64[])
STEPWIRE_LACKS("clocks", fmi3SetIntervalDecimal, const Reference[], size_t, const double[])
STEPWIRE_LACKS("clocks", fmi3SetIntervalFraction, const Reference[], size_t, const fmi3UInt64[],
               const fmi3UInt64[])
STEPWIRE_LACKS("clocks", fmi3SetShiftDecimal, const Reference[], size_t, const double[])
STEPWIRE_LACKS("clocks", fmi3SetShiftFraction, const Reference[], size_t, const fmi3UInt64[],
               const fmi3UInt64[])

}  // extern "C"

}  // namespace stepwire::fmu
