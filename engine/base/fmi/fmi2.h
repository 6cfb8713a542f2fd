/* The C interface of FMI 2.0: types and functions that units and their importers share. Our own declarations,
   after the text of the standard (Functional Mock-up Interface 2.0, Modelica Association, 2014). */
#ifndef STEPWIRE_FMI2_H
#define STEPWIRE_FMI2_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef void* fmi2Component;
typedef void* fmi2ComponentEnvironment;
typedef void* fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char* fmi2String;
typedef char fmi2Byte;

enum { fmi2False, fmi2True };

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;

typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                                   fmi2String category, fmi2String message, ...);
typedef struct {
  fmi2CallbackLogger logger;
  void* (*allocateMemory)(size_t count, size_t size);
  void (*freeMemory)(void* memory);
  void (*stepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
  fmi2Boolean newDiscreteStatesNeeded;
  fmi2Boolean terminateSimulation;
  fmi2Boolean nominalsOfContinuousStatesChanged;
  fmi2Boolean valuesOfContinuousStatesChanged;
  fmi2Boolean nextEventTimeDefined;
  fmi2Real nextEventTime;
} fmi2EventInfo;

const char* fmi2GetVersion(void);
const char* fmi2GetTypesPlatform(void);
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean visible, fmi2Boolean logging);
void fmi2FreeInstance(fmi2Component unit);
fmi2Status fmi2SetupExperiment(fmi2Component unit, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop);
fmi2Status fmi2EnterInitializationMode(fmi2Component unit);
fmi2Status fmi2ExitInitializationMode(fmi2Component unit);
fmi2Status fmi2Terminate(fmi2Component unit);

fmi2Status fmi2GetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count, fmi2Real values[]);
fmi2Status fmi2SetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]);
fmi2Status fmi2GetInteger(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]);
fmi2Status fmi2SetInteger(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]);
fmi2Status fmi2GetBoolean(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]);
fmi2Status fmi2SetBoolean(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[]);

fmi2Status fmi2GetFMUstate(fmi2Component unit, fmi2FMUstate* state);
fmi2Status fmi2SetFMUstate(fmi2Component unit, fmi2FMUstate state);
fmi2Status fmi2FreeFMUstate(fmi2Component unit, fmi2FMUstate* state);
fmi2Status fmi2SerializedFMUstateSize(fmi2Component unit, fmi2FMUstate state, size_t* size);
fmi2Status fmi2SerializeFMUstate(fmi2Component unit, fmi2FMUstate state, fmi2Byte bytes[], size_t size);
fmi2Status fmi2DeSerializeFMUstate(fmi2Component unit, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state);

fmi2Status fmi2SetTime(fmi2Component unit, fmi2Real time);
fmi2Status fmi2SetContinuousStates(fmi2Component unit, const fmi2Real states[], size_t count);
fmi2Status fmi2GetContinuousStates(fmi2Component unit, fmi2Real states[], size_t count);
fmi2Status fmi2GetDerivatives(fmi2Component unit, fmi2Real derivatives[], size_t count);
fmi2Status fmi2GetEventIndicators(fmi2Component unit, fmi2Real indicators[], size_t count);
fmi2Status fmi2CompletedIntegratorStep(fmi2Component unit, fmi2Boolean no_return_before, fmi2Boolean* enter_event,
                                       fmi2Boolean* terminate);
fmi2Status fmi2EnterEventMode(fmi2Component unit);
fmi2Status fmi2NewDiscreteStates(fmi2Component unit, fmi2EventInfo* info);
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component unit);

fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real time, fmi2Real length, fmi2Boolean no_return_before);

typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

fmi2Status fmi2SetDebugLogging(fmi2Component unit, fmi2Boolean logging, size_t count, const fmi2String categories[]);
fmi2Status fmi2Reset(fmi2Component unit);
fmi2Status fmi2GetString(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                         fmi2String values[]);
fmi2Status fmi2SetString(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                         const fmi2String values[]);
fmi2Status fmi2GetDirectionalDerivative(fmi2Component unit, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[], size_t known_count,
                                        const fmi2Real seed[], fmi2Real sensitivity[]);
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component unit, fmi2Real nominals[], size_t count);
fmi2Status fmi2SetRealInputDerivatives(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[]);
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component unit, const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer orders[], fmi2Real values[]);
fmi2Status fmi2CancelStep(fmi2Component unit);
fmi2Status fmi2GetStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Status* value);
fmi2Status fmi2GetRealStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Real* value);
fmi2Status fmi2GetIntegerStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Integer* value);
fmi2Status fmi2GetBooleanStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2Boolean* value);
fmi2Status fmi2GetStringStatus(fmi2Component unit, const fmi2StatusKind kind, fmi2String* value);

#ifdef __cplusplus
}
#endif

#endif
