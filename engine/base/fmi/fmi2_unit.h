/* The rest of the C interface of FMI 2.0, beside fmi2.h: what a unit has to have and our importer does not call.
   Our own declarations, after the text of the standard (Functional Mock-up Interface 2.0, Modelica Association,
   2014). */
#ifndef STEPWIRE_FMI2_UNIT_H
#define STEPWIRE_FMI2_UNIT_H

#include "engine/base/fmi/fmi2.h"

#ifdef __cplusplus
extern "C" {
#endif

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
