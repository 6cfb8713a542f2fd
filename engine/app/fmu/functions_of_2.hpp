#pragma once

// FMI 2 functions of an exported unit. Only the single source of the unit includes this file.

#include <string>

#include "engine/app/fmu/unit_calls.hpp"
#include "engine/base/fmi/fmi2.h"

namespace stepwire::fmu {

/// FMI 2, and the arguments that its callers give to an instance.
struct Fmi2 {
  using Status = fmi2Status;
  static constexpr char number[] = "Real", wrong_token[] = "the GUID is not that of this unit";

  std::string name;
  fmi2CallbackLogger logger;
  fmi2ComponentEnvironment environment;

  void log(Status status, const char* message) const {
    if (logger) logger(environment, name.c_str(), status, "logStatusError", "%s", message);
  }
};

using Own = Instance<Fmi2>;
using Boolean = fmi2Boolean;
using Byte = fmi2Byte;
using Reference = fmi2ValueReference;

}  // namespace stepwire::fmu

#define STEPWIRE_FMI(name) fmi2##name
#define STEPWIRE_FMI_2_3(name, other) fmi2##name
#include "engine/app/fmu/common_functions.hpp"

namespace stepwire::fmu {

extern "C" {

const char* fmi2GetVersion(void) {
  return "2.0";
}
const char* fmi2GetTypesPlatform(void) {
  return "default";
}
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean) {
  const Fmi2 caller{name ? name : "", functions ? functions->logger : nullptr,
                    functions ? functions->componentEnvironment : nullptr};
  return Own::make(caller, guid, type == fmi2ModelExchange, nullptr);
}

// Keeps the start time for the initialization.
STEPWIRE_DOES(fmi2SetupExperiment, (void* instance, Boolean, double, double start, Boolean, double),
              unit.allows(0u | Phase::made, "SetupExperiment") ? (end.last = start, Status::ok)
                                                               : Status::error)
STEPWIRE_DOES(fmi2EnterInitializationMode, (void* instance), unit.enter_initialization(end.last))

STEPWIRE_DOES(fmi2GetReal, (void* instance, const Reference of[], size_t count, double values[]),
              unit.get({of, count}, values, count))
STEPWIRE_DOES(fmi2SetReal, (void* instance, const Reference of[], size_t count, const double values[]),
              unit.set({of, count}, values, count))
#define STEPWIRE_NONE_OF(Type)                                                                        \
  STEPWIRE_DOES(fmi2Get##Type, (void* instance, const Reference[], size_t count, fmi2##Type[]),       \
                Own::none(unit, count, #Type))                                                        \
  STEPWIRE_DOES(fmi2Set##Type, (void* instance, const Reference[], size_t count, const fmi2##Type[]), \
                Own::none(unit, count, #Type))
STEPWIRE_NONE_OF(Integer)
STEPWIRE_NONE_OF(Boolean)
STEPWIRE_NONE_OF(String)
#undef STEPWIRE_NONE_OF
STEPWIRE_DOES(fmi2GetDirectionalDerivative,
              (void* instance, const Reference of[], size_t count, const Reference by[], size_t knowns,
               const double seed[], double sensitivity[]),
              unit.derivative({of, count}, {by, knowns}, seed, knowns, sensitivity, count))

fmi2Status fmi2NewDiscreteStates(fmi2Component instance, fmi2EventInfo* info) {
  return Own::call(instance, [&](ExportedUnit& unit, StepEnd&) {
    if (!unit.given("NewDiscreteStates", {{"eventInfo", info}})) return Status::error;
    bool terminates = false;
    double next = 0.0;
    const Status status = unit.update(terminates, next);
    *info = {fmi2False, terminates, fmi2False, fmi2False, std::isfinite(next), next};
    return status;
  });
}

// A step that ended early returns fmi2Discard; the caller reads the reached time by fmi2GetRealStatus.
fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real time, fmi2Real length, fmi2Boolean) {
  return Own::call(instance, [&](ExportedUnit& unit, StepEnd& end) {
    const Status status = unit.step(time, length, end);
    return status == Status::ok && !end.whole ? Status::discard : status;
  });
}
STEPWIRE_DOES(fmi2GetStatus, (void* instance, fmi2StatusKind, fmi2Status* value),
              tell(unit, "GetStatus", "value", value, fmi2OK))
STEPWIRE_DOES(fmi2GetRealStatus, (void* instance, fmi2StatusKind kind, fmi2Real* value),
              kind != fmi2LastSuccessfulTime ? unit.refuse("it has no such status that is real")
                                             : tell(unit, "GetRealStatus", "value", value, end.last))
STEPWIRE_DOES(fmi2GetBooleanStatus, (void* instance, fmi2StatusKind kind, Boolean* value),
              kind != fmi2Terminated ? unit.refuse("it has no such status that is boolean")
                                     : tell(unit, "GetBooleanStatus", "value", value, end.terminates))
STEPWIRE_LACKS("status that is an integer", fmi2GetIntegerStatus, fmi2StatusKind, fmi2Integer*)
STEPWIRE_LACKS("status that is a text", fmi2GetStringStatus, fmi2StatusKind, fmi2String*)
STEPWIRE_LACKS("steps that go on in the background", fmi2CancelStep)
STEPWIRE_LACKS("interpolation of inputs", fmi2SetRealInputDerivatives, const Reference[], size_t,
               const fmi2Integer[], const double[])
STEPWIRE_LACKS("derivatives of outputs by the time", fmi2GetRealOutputDerivatives, const Reference[], size_t,
               const fmi2Integer[], double[])

}  // extern "C"

}  // namespace stepwire::fmu
