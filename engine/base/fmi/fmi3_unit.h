/* The rest of the C interface of FMI 3.0, beside fmi3.h: what a unit has to have and our importer does not call.
   Our own declarations, after the text of the standard (Functional Mock-up Interface 3.0, Modelica Association,
   2022). */
#ifndef STEPWIRE_FMI3_UNIT_H
#define STEPWIRE_FMI3_UNIT_H

#include "engine/base/fmi/fmi3.h"

#ifdef __cplusplus
extern "C" {
#endif

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
