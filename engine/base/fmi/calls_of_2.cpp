// Calls of FMI 2.
#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "engine/base/fmi/calls_of.hpp"
#include "engine/base/fmi/fmi2_unit.h"
#include "engine/base/fmi/library.hpp"
#include "engine/base/fmi/unit_calls.hpp"

namespace stepwire::fmi {

namespace {

void log(fmi2ComponentEnvironment environment, fmi2String, fmi2Status status, fmi2String, fmi2String message,
         ...) {
  const UsualFloatingPoint ours;
  if (!is_fault(static_cast<int>(status))) return;
  char text[400];
  va_list values;
  va_start(values, message);
  std::vsnprintf(text, sizeof text, message, values);
  va_end(values);
  static_cast<LogText*>(environment)->take(text);
}

struct Functions {
  explicit Functions(const Library& library) {
    library.find(make, "fmi2Instantiate");
    library.find(free_instance, "fmi2FreeInstance");
    library.find(set_up, "fmi2SetupExperiment");
    library.find(enter_initialization, "fmi2EnterInitializationMode");
    library.find(exit_initialization, "fmi2ExitInitializationMode");
    library.find(terminate, "fmi2Terminate");
    library.find(get_real, "fmi2GetReal");
    library.find(set_real, "fmi2SetReal");
    library.find(get_integer, "fmi2GetInteger");
    library.find(set_integer, "fmi2SetInteger");
    library.find(get_boolean, "fmi2GetBoolean");
    library.find(set_boolean, "fmi2SetBoolean");
    library.find(get_state, "fmi2GetFMUstate");
    library.find(set_state, "fmi2SetFMUstate");
    library.find(free_state, "fmi2FreeFMUstate");
    library.find(state_size, "fmi2SerializedFMUstateSize");
    library.find(serialize, "fmi2SerializeFMUstate");
    library.find(deserialize, "fmi2DeSerializeFMUstate");
  }
  decltype(fmi2Instantiate)* make;
  decltype(fmi2FreeInstance)* free_instance;
  decltype(fmi2SetupExperiment)* set_up;
  decltype(fmi2EnterInitializationMode)* enter_initialization;
  decltype(fmi2ExitInitializationMode)* exit_initialization;
  decltype(fmi2Terminate)* terminate;
  decltype(fmi2GetReal)* get_real;
  decltype(fmi2SetReal)* set_real;
  decltype(fmi2GetInteger)* get_integer;
  decltype(fmi2SetInteger)* set_integer;
  decltype(fmi2GetBoolean)* get_boolean;
  decltype(fmi2SetBoolean)* set_boolean;
  decltype(fmi2GetFMUstate)* get_state;
  decltype(fmi2SetFMUstate)* set_state;
  decltype(fmi2FreeFMUstate)* free_state;
  decltype(fmi2SerializedFMUstateSize)* state_size;
  decltype(fmi2SerializeFMUstate)* serialize;
  decltype(fmi2DeSerializeFMUstate)* deserialize;
};

struct ModelFunctions {
  explicit ModelFunctions(const Library& library) {
    library.find(set_time, "fmi2SetTime");
    library.find(set_states, "fmi2SetContinuousStates");
    library.find(get_states, "fmi2GetContinuousStates");
    library.find(get_slopes, "fmi2GetDerivatives");
    library.find(get_indicators, "fmi2GetEventIndicators");
    library.find(complete_step, "fmi2CompletedIntegratorStep");
    library.find(enter_event, "fmi2EnterEventMode");
    library.find(update, "fmi2NewDiscreteStates");
    library.find(leave_event, "fmi2EnterContinuousTimeMode");
  }
  decltype(fmi2SetTime)* set_time;
  decltype(fmi2SetContinuousStates)* set_states;
  decltype(fmi2GetContinuousStates)* get_states;
  decltype(fmi2GetDerivatives)* get_slopes;
  decltype(fmi2GetEventIndicators)* get_indicators;
  decltype(fmi2CompletedIntegratorStep)* complete_step;
  decltype(fmi2EnterEventMode)* enter_event;
  decltype(fmi2NewDiscreteStates)* update;
  decltype(fmi2EnterContinuousTimeMode)* leave_event;
};

class Second : public UnitCalls {
 public:
  Second(const Package& package, Mode mode, const std::string& name, CallNote& note)
      : UnitCalls(note),
        library_(package.binary(interface_of(package.description(), mode)), note),
        f_(library_) {
    if (mode == Mode::co_simulation) {
      library_.find(step_, "fmi2DoStep");
      library_.find(get_boolean_status_, "fmi2GetBooleanStatus");
      library_.find_if_there(get_real_status_, "fmi2GetRealStatus");
    } else {
      model_.emplace(library_);
    }
    callbacks_.logger = log;
    callbacks_.allocateMemory = std::calloc;
    callbacks_.freeMemory = std::free;
    callbacks_.stepFinished = nullptr;
    callbacks_.componentEnvironment = &log_;
    unit_ = call("fmi2Instantiate", f_.make, name.c_str(),
                 mode == Mode::co_simulation ? fmi2CoSimulation : fmi2ModelExchange,
                 package.description().token.c_str(), package.resources_uri().c_str(), &callbacks_, fmi2False,
                 fmi2False);
    if (!unit_)
      throw UnitError("its binary refuses to be instantiated" + (log_.empty() ? "" : ": " + log_.text()));
  }
  ~Second() override {
    if (started_ && !failed()) call("fmi2Terminate", f_.terminate, unit_);
    call("fmi2FreeInstance", f_.free_instance, unit_);
  }

  bool set_up(double start) override {
    return done("fmi2SetupExperiment", f_.set_up, unit_, fmi2False, 0.0, start, fmi2False, 0.0) &&
           done("fmi2EnterInitializationMode", f_.enter_initialization, unit_);
  }
  bool initialize() override {
    return started_ = done("fmi2ExitInitializationMode", f_.exit_initialization, unit_);
  }
  bool get(Type type, const std::uint32_t* references, std::size_t count, void* values,
           std::size_t) override {
    if (type == Type::float64)
      return done("fmi2GetReal", f_.get_real, unit_, references, count, static_cast<fmi2Real*>(values));
    if (type == Type::int32)
      return done("fmi2GetInteger", f_.get_integer, unit_, references, count,
                  static_cast<fmi2Integer*>(values));
    return done("fmi2GetBoolean", f_.get_boolean, unit_, references, count,
                static_cast<fmi2Boolean*>(values));
  }
  bool set(Type type, const std::uint32_t* references, std::size_t count, const void* values,
           std::size_t) override {
    if (type == Type::float64)
      return done("fmi2SetReal", f_.set_real, unit_, references, count, static_cast<const fmi2Real*>(values));
    if (type == Type::int32)
      return done("fmi2SetInteger", f_.set_integer, unit_, references, count,
                  static_cast<const fmi2Integer*>(values));
    return done("fmi2SetBoolean", f_.set_boolean, unit_, references, count,
                static_cast<const fmi2Boolean*>(values));
  }

  bool set_time(double time) override { return done("fmi2SetTime", model_->set_time, unit_, time); }
  bool set_states(const double* states, std::size_t count) override {
    return done("fmi2SetContinuousStates", model_->set_states, unit_, states, count);
  }
  bool get_states(double* states, std::size_t count) override {
    return done("fmi2GetContinuousStates", model_->get_states, unit_, states, count);
  }
  bool get_slopes(double* slopes, std::size_t count) override {
    return done("fmi2GetDerivatives", model_->get_slopes, unit_, slopes, count);
  }
  bool get_indicators(double* indicators, std::size_t count) override {
    return done("fmi2GetEventIndicators", model_->get_indicators, unit_, indicators, count);
  }
  bool complete_step(StepInfo& info) override {
    fmi2Boolean enters = fmi2False, ends = fmi2False;
    const bool whole =
        done("fmi2CompletedIntegratorStep", model_->complete_step, unit_, fmi2True, &enters, &ends);
    info.terminates = ends != fmi2False;
    info.enters_event = enters != fmi2False;
    return whole;
  }
  bool enter_event() override { return done("fmi2EnterEventMode", model_->enter_event, unit_); }
  bool update(EventInfo& info) override {
    fmi2EventInfo told{};
    const bool whole = done("fmi2NewDiscreteStates", model_->update, unit_, &told);
    info = {told.newDiscreteStatesNeeded != fmi2False, told.terminateSimulation != fmi2False,
            told.valuesOfContinuousStatesChanged != fmi2False, told.nextEventTimeDefined != fmi2False,
            told.nextEventTime};
    return whole;
  }
  bool leave_event() override { return done("fmi2EnterContinuousTimeMode", model_->leave_event, unit_); }

  bool step(double time, double length, StepInfo& info) override {
    const int status = static_cast<int>(call("fmi2DoStep", step_, unit_, time, length, fmi2False));
    info.terminates = status == fmi2Discard && wants_end();
    info.reached = info.terminates ? std::max(time, last_successful_time(time)) : time + length;
    info.made = !info.terminates || info.reached > time;
    return info.terminates || accept("fmi2DoStep", status);
  }

  std::size_t state_size() override {
    fmi2FMUstate state = nullptr;
    std::size_t size = 0;
    const bool whole = done("fmi2GetFMUstate", f_.get_state, unit_, &state) &&
                       done("fmi2SerializedFMUstateSize", f_.state_size, unit_, state, &size);
    if (state) call("fmi2FreeFMUstate", f_.free_state, unit_, &state);
    return whole ? size : 0;
  }
  bool save(char* bytes, std::size_t count) override {
    fmi2FMUstate state = nullptr;
    const bool whole = done("fmi2GetFMUstate", f_.get_state, unit_, &state) &&
                       done("fmi2SerializeFMUstate", f_.serialize, unit_, state, bytes, count);
    if (state) call("fmi2FreeFMUstate", f_.free_state, unit_, &state);
    return whole;
  }
  bool load(const char* bytes, std::size_t count) override {
    fmi2FMUstate state = nullptr;
    const bool whole = done("fmi2DeSerializeFMUstate", f_.deserialize, unit_, bytes, count, &state) &&
                       done("fmi2SetFMUstate", f_.set_state, unit_, state);
    if (state) call("fmi2FreeFMUstate", f_.free_state, unit_, &state);
    return whole;
  }

 private:
  /// Returns the last successful time of a discarded step; `before` if the unit does not provide it.
  double last_successful_time(double before) {
    fmi2Real reached = before;
    if (!get_real_status_) return before;
    const auto status = call("fmi2GetRealStatus", get_real_status_, unit_, fmi2LastSuccessfulTime, &reached);
    return status == fmi2OK ? reached : before;
  }
  /// True where the unit discarded the step in order to end the run.
  bool wants_end() {
    fmi2Boolean terminated = fmi2False;
    return call("fmi2GetBooleanStatus", get_boolean_status_, unit_, fmi2Terminated, &terminated) == fmi2OK &&
           terminated != fmi2False;
  }

  fmi2CallbackFunctions callbacks_{};
  Library library_;
  Functions f_;
  std::optional<ModelFunctions> model_;
  decltype(fmi2DoStep)* step_ = nullptr;
  decltype(fmi2GetBooleanStatus)* get_boolean_status_ = nullptr;
  decltype(fmi2GetRealStatus)* get_real_status_ = nullptr;
  fmi2Component unit_ = nullptr;
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Calls> instance_of_2(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note) {
  return std::make_unique<Second>(package, mode, name, note);
}

}  // namespace stepwire::fmi
