#pragma once

// Functions of an exported unit that FMI 2 and FMI 3 have in common. functions_of_2.hpp and
// functions_of_3.hpp include this file. Before that they define Own, the instance, and the macros for names:
// STEPWIRE_FMI(name), and STEPWIRE_FMI_2_3(name in FMI 2, name in FMI 3).

namespace stepwire::fmu {

extern "C" {

// A function: its name, its arguments, of which the first is `instance`, and the expression of its status,
// with `unit` and `end`, the end of the last step.
#define STEPWIRE_DOES(name, arguments, ...)                                                              \
  Own::Result name arguments {                                                                           \
    return Own::call(instance, [&]([[maybe_unused]] ExportedUnit& unit, [[maybe_unused]] StepEnd& end) { \
      return __VA_ARGS__;                                                                                \
    });                                                                                                  \
  }
// A function that units do not have: its name, its arguments after the instance, and the thing that is
// missing.
#define STEPWIRE_LACKS(what, name, ...) \
  STEPWIRE_DOES(name, (void* instance __VA_OPT__(, ) __VA_ARGS__), unit.refuse("it has no " what))

STEPWIRE_DOES(STEPWIRE_FMI(SetDebugLogging), (void* instance, Boolean, size_t, const char* const[]),
              Status::ok)
void STEPWIRE_FMI(FreeInstance)(void* instance) {
  delete static_cast<Own*>(instance);
}
STEPWIRE_DOES(STEPWIRE_FMI(ExitInitializationMode), (void* instance), unit.leave_initialization())
STEPWIRE_DOES(STEPWIRE_FMI(Terminate), (void* instance), unit.terminate())
STEPWIRE_DOES(STEPWIRE_FMI(Reset), (void* instance), end = {}, unit.reset())

STEPWIRE_DOES(STEPWIRE_FMI_2_3(GetFMUstate, GetFMUState), (void* instance, void** state),
              save_state(unit, state))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(SetFMUstate, SetFMUState), (void* instance, void* state),
              load_state(unit, state))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(FreeFMUstate, FreeFMUState), (void* instance, void** state), free_state(state))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(SerializedFMUstateSize, SerializedFMUStateSize),
              (void* instance, void*, size_t* size),
              tell(unit, "SerializedFMUStateSize", "size", size, unit.state_bytes()))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(SerializeFMUstate, SerializeFMUState),
              (void* instance, void* state, Byte bytes[], size_t size), write_state(unit, state, bytes, size))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(DeSerializeFMUstate, DeserializeFMUState),
              (void* instance, const Byte bytes[], size_t size, void** state),
              read_state(unit, bytes, size, state))

STEPWIRE_DOES(STEPWIRE_FMI(SetTime), (void* instance, double time), unit.set_time(time))
STEPWIRE_DOES(STEPWIRE_FMI(SetContinuousStates), (void* instance, const double states[], size_t count),
              unit.set_states(states, count))
STEPWIRE_DOES(STEPWIRE_FMI(GetContinuousStates), (void* instance, double states[], size_t count),
              unit.get_states(states, count))
STEPWIRE_DOES(STEPWIRE_FMI(GetNominalsOfContinuousStates), (void* instance, double nominals[], size_t count),
              unit.get_nominals(nominals, count))
STEPWIRE_DOES(STEPWIRE_FMI_2_3(GetDerivatives, GetContinuousStateDerivatives),
              (void* instance, double slopes[], size_t count), unit.get_slopes(slopes, count))
STEPWIRE_DOES(STEPWIRE_FMI(GetEventIndicators), (void* instance, double indicators[], size_t count),
              unit.get_crossings(indicators, count))
STEPWIRE_DOES(STEPWIRE_FMI(EnterEventMode), (void* instance), unit.enter_event())
STEPWIRE_DOES(STEPWIRE_FMI(EnterContinuousTimeMode), (void* instance), unit.leave_event())
Own::Result STEPWIRE_FMI(CompletedIntegratorStep)(void* instance, Boolean, Boolean* enter,
                                                  Boolean* terminate) {
  return Own::call(instance, [&](ExportedUnit& unit, StepEnd&) {
    if (!unit.given("CompletedIntegratorStep",
                    {{"enterEventMode", enter}, {"terminateSimulation", terminate}}))
      return Status::error;
    bool terminates = false;
    const Status status = unit.complete_step(terminates);
    *enter = false;
    *terminate = terminates;
    return status;
  });
}

}  // extern "C"

}  // namespace stepwire::fmu
