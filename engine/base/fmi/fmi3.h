/* The C interface of FMI 3.0: types and functions that units and their importers share. Our own declarations,
   after the text of the standard (Functional Mock-up Interface 3.0, Modelica Association, 2022). */
#ifndef STEPWIRE_FMI3_H
#define STEPWIRE_FMI3_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef void* fmi3Instance;
typedef void* fmi3InstanceEnvironment;
typedef void* fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef char fmi3Char;
typedef const fmi3Char* fmi3String;
typedef uint8_t fmi3Byte;

typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                                       fmi3String message);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment environment, fmi3Float64 time,
                                               fmi3Boolean variables_set, fmi3Boolean variables_get,
                                               fmi3Boolean step_finished, fmi3Boolean may_return_early,
                                               fmi3Boolean* early_return, fmi3Float64* early_return_time);

const char* fmi3GetVersion(void);
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log);
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                         fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean event_mode,
                                         fmi3Boolean early_return, const fmi3ValueReference intermediate[],
                                         size_t intermediate_count, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update);
void fmi3FreeInstance(fmi3Instance unit);
fmi3Status fmi3EnterInitializationMode(fmi3Instance unit, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop);
fmi3Status fmi3ExitInitializationMode(fmi3Instance unit);
fmi3Status fmi3Terminate(fmi3Instance unit);

fmi3Status fmi3GetFloat64(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                          fmi3Float64 values[], size_t numbers);
fmi3Status fmi3SetFloat64(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t numbers);

fmi3Status fmi3GetFMUState(fmi3Instance unit, fmi3FMUState* state);
fmi3Status fmi3SetFMUState(fmi3Instance unit, fmi3FMUState state);
fmi3Status fmi3FreeFMUState(fmi3Instance unit, fmi3FMUState* state);
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance unit, fmi3FMUState state, size_t* size);
fmi3Status fmi3SerializeFMUState(fmi3Instance unit, fmi3FMUState state, fmi3Byte bytes[], size_t size);
fmi3Status fmi3DeserializeFMUState(fmi3Instance unit, const fmi3Byte bytes[], size_t size, fmi3FMUState* state);

fmi3Status fmi3SetTime(fmi3Instance unit, fmi3Float64 time);
fmi3Status fmi3SetContinuousStates(fmi3Instance unit, const fmi3Float64 states[], size_t count);
fmi3Status fmi3GetContinuousStates(fmi3Instance unit, fmi3Float64 states[], size_t count);
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance unit, fmi3Float64 derivatives[], size_t count);
fmi3Status fmi3GetEventIndicators(fmi3Instance unit, fmi3Float64 indicators[], size_t count);
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance unit, fmi3Boolean no_return_before, fmi3Boolean* enter_event,
                                       fmi3Boolean* terminate);
fmi3Status fmi3EnterEventMode(fmi3Instance unit);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance unit, fmi3Boolean* again, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_defined, fmi3Float64* next);
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance unit);

fmi3Status fmi3DoStep(fmi3Instance unit, fmi3Float64 time, fmi3Float64 length, fmi3Boolean no_return_before,
                      fmi3Boolean* event, fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last);

typedef const fmi3Byte* fmi3Binary;
typedef bool fmi3Clock;
typedef enum { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent } fmi3DependencyKind;
typedef enum { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged } fmi3IntervalQualifier;
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment environment);

fmi3Status fmi3SetDebugLogging(fmi3Instance unit, fmi3Boolean logging, size_t count, const fmi3String categories[]);
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock);
fmi3Status fmi3Reset(fmi3Instance unit);
fmi3Status fmi3EnterConfigurationMode(fmi3Instance unit);
fmi3Status fmi3ExitConfigurationMode(fmi3Instance unit);
fmi3Status fmi3EnterStepMode(fmi3Instance unit);

#define STEPWIRE_FMI3_VALUES(Type)                                                                             \
  fmi3Status fmi3Get##Type(fmi3Instance unit, const fmi3ValueReference references[], size_t count,            \
                           fmi3##Type values[], size_t numbers);                                               \
  fmi3Status fmi3Set##Type(fmi3Instance unit, const fmi3ValueReference references[], size_t count,            \
                           const fmi3##Type values[], size_t numbers);
STEPWIRE_FMI3_VALUES(Float32)
STEPWIRE_FMI3_VALUES(Int8)
STEPWIRE_FMI3_VALUES(UInt8)
STEPWIRE_FMI3_VALUES(Int16)
STEPWIRE_FMI3_VALUES(UInt16)
STEPWIRE_FMI3_VALUES(Int32)
STEPWIRE_FMI3_VALUES(UInt32)
STEPWIRE_FMI3_VALUES(Int64)
STEPWIRE_FMI3_VALUES(UInt64)
STEPWIRE_FMI3_VALUES(Boolean)
STEPWIRE_FMI3_VALUES(String)
#undef STEPWIRE_FMI3_VALUES
fmi3Status fmi3GetBinary(fmi3Instance unit, const fmi3ValueReference references[], size_t count, size_t sizes[],
                         fmi3Binary values[], size_t numbers);
fmi3Status fmi3SetBinary(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                         const size_t sizes[], const fmi3Binary values[], size_t numbers);
fmi3Status fmi3GetClock(fmi3Instance unit, const fmi3ValueReference references[], size_t count, fmi3Clock values[]);
fmi3Status fmi3SetClock(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                        const fmi3Clock values[]);

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance unit, fmi3ValueReference reference, size_t* count);
fmi3Status fmi3GetVariableDependencies(fmi3Instance unit, fmi3ValueReference dependent, size_t elements[],
                                       fmi3ValueReference independents[], size_t independent_elements[],
                                       fmi3DependencyKind kinds[], size_t count);
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance unit, const fmi3ValueReference unknowns[], size_t unknown_count,
                                        const fmi3ValueReference knowns[], size_t known_count,
                                        const fmi3Float64 seed[], size_t seeds, fmi3Float64 sensitivity[],
                                        size_t sensitivities);
fmi3Status fmi3GetAdjointDerivative(fmi3Instance unit, const fmi3ValueReference unknowns[], size_t unknown_count,
                                    const fmi3ValueReference knowns[], size_t known_count, const fmi3Float64 seed[],
                                    size_t seeds, fmi3Float64 sensitivity[], size_t sensitivities);

fmi3Status fmi3GetIntervalDecimal(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                  fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]);
fmi3Status fmi3GetIntervalFraction(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                   fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]);
fmi3Status fmi3GetShiftDecimal(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                               fmi3Float64 shifts[]);
fmi3Status fmi3GetShiftFraction(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                fmi3UInt64 counters[], fmi3UInt64 resolutions[]);
fmi3Status fmi3SetIntervalDecimal(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                  const fmi3Float64 intervals[]);
fmi3Status fmi3SetIntervalFraction(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                   const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]);
fmi3Status fmi3SetShiftDecimal(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                               const fmi3Float64 shifts[]);
fmi3Status fmi3SetShiftFraction(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]);
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance unit);
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance unit, fmi3Float64 nominals[], size_t count);
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance unit, size_t* count);
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance unit, size_t* count);
fmi3Status fmi3GetOutputDerivatives(fmi3Instance unit, const fmi3ValueReference references[], size_t count,
                                    const fmi3Int32 orders[], fmi3Float64 values[], size_t numbers);
fmi3Status fmi3ActivateModelPartition(fmi3Instance unit, fmi3ValueReference clock, fmi3Float64 time);

#ifdef __cplusplus
}
#endif

#endif
