// Calls of FMI 3.
#include <fmt/format.h>

#include <optional>

#include "engine/base/fmi/calls_of.hpp"
#include "engine/base/fmi/fmi3.h"
#include "engine/base/fmi/library.hpp"
#include "engine/base/fmi/unit_calls.hpp"

namespace stepwire::fmi {

namespace {

void log(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String, fmi3String message) {
  const UsualFloatingPoint ours;
  if (is_fault(static_cast<int>(status))) static_cast<LogText*>(environment)->take(message);
}

/// Functions common to both interfaces, by their names in the standard.
struct Functions {
  explicit Functions(const Library& library) {
    library.find(free_instance, "fmi3FreeInstance");
    library.find(enter_initialization, "fmi3EnterInitializationMode");
    library.find(exit_initialization, "fmi3ExitInitializationMode");
    library.find(terminate, "fmi3Terminate");
    library.find(get_state, "fmi3GetFMUState");
    library.find(set_state, "fmi3SetFMUState");
    library.find(free_state, "fmi3FreeFMUState");
    library.find(state_size, "fmi3SerializedFMUStateSize");
    library.find(serialize, "fmi3SerializeFMUState");
    library.find(deserialize, "fmi3DeserializeFMUState");
  }
  decltype(fmi3FreeInstance)* free_instance;
  decltype(fmi3EnterInitializationMode)* enter_initialization;
  decltype(fmi3ExitInitializationMode)* exit_initialization;
  decltype(fmi3Terminate)* terminate;
  decltype(fmi3GetFMUState)* get_state;
  decltype(fmi3SetFMUState)* set_state;
  decltype(fmi3FreeFMUState)* free_state;
  decltype(fmi3SerializedFMUStateSize)* state_size;
  decltype(fmi3SerializeFMUState)* serialize;
  decltype(fmi3DeserializeFMUState)* deserialize;
};

using AnyFunction = void (*)();

/// Calls a getter or setter of the standard with pointers to its value type.
template <class Value>
fmi3Status get_values(AnyFunction function, fmi3Instance unit, const fmi3ValueReference* references,
                      size_t count, void* values, size_t numbers) {
  using Get = fmi3Status (*)(fmi3Instance, const fmi3ValueReference*, size_t, Value*, size_t);
  return reinterpret_cast<Get>(function)(unit, references, count, static_cast<Value*>(values), numbers);
}

template <class Value>
fmi3Status set_values(AnyFunction function, fmi3Instance unit, const fmi3ValueReference* references,
                      size_t count, const void* values, size_t numbers) {
  using Set = fmi3Status (*)(fmi3Instance, const fmi3ValueReference*, size_t, const Value*, size_t);
  return reinterpret_cast<Set>(function)(unit, references, count, static_cast<const Value*>(values), numbers);
}

/// A value type: the suffix of its function names, and the typed wrappers.
struct ValueType {
  const char* name;
  decltype(&get_values<fmi3Float64>) get;
  decltype(&set_values<fmi3Float64>) set;
};

template <class Value>
constexpr ValueType value_type(const char* name) {
  return {name, &get_values<Value>, &set_values<Value>};
}

constexpr ValueType value_types[] = {
    value_type<fmi3Float64>("Float64"), value_type<fmi3Float32>("Float32"), value_type<fmi3Int8>("Int8"),
    value_type<fmi3UInt8>("UInt8"),     value_type<fmi3Int16>("Int16"),     value_type<fmi3UInt16>("UInt16"),
    value_type<fmi3Int32>("Int32"),     value_type<fmi3UInt32>("UInt32"),   value_type<fmi3Int64>("Int64"),
    value_type<fmi3UInt64>("UInt64"),   value_type<fmi3Boolean>("Boolean")};
constexpr std::size_t type_count = std::size(value_types);

struct ValueFunctions {
  explicit ValueFunctions(const Library& library) {
    for (std::size_t i = 0; i < type_count; ++i) {
      library.find(get[i], fmt::format("fmi3Get{}", value_types[i].name).c_str());
      library.find(set[i], fmt::format("fmi3Set{}", value_types[i].name).c_str());
    }
  }
  AnyFunction get[type_count];
  AnyFunction set[type_count];
};

/// Returns the index of a type in these tables.
std::size_t place_of(Type type) {
  return type == Type::boolean ? type_count - 1 : static_cast<std::size_t>(type);
}

struct ModelFunctions {
  explicit ModelFunctions(const Library& library) {
    library.find(set_time, "fmi3SetTime");
    library.find(set_states, "fmi3SetContinuousStates");
    library.find(get_states, "fmi3GetContinuousStates");
    library.find(get_slopes, "fmi3GetContinuousStateDerivatives");
    library.find(get_indicators, "fmi3GetEventIndicators");
    library.find(complete_step, "fmi3CompletedIntegratorStep");
    library.find(enter_event, "fmi3EnterEventMode");
    library.find(update, "fmi3UpdateDiscreteStates");
    library.find(leave_event, "fmi3EnterContinuousTimeMode");
  }
  decltype(fmi3SetTime)* set_time;
  decltype(fmi3SetContinuousStates)* set_states;
  decltype(fmi3GetContinuousStates)* get_states;
  decltype(fmi3GetContinuousStateDerivatives)* get_slopes;
  decltype(fmi3GetEventIndicators)* get_indicators;
  decltype(fmi3CompletedIntegratorStep)* complete_step;
  decltype(fmi3EnterEventMode)* enter_event;
  decltype(fmi3UpdateDiscreteStates)* update;
  decltype(fmi3EnterContinuousTimeMode)* leave_event;
};

class Third : public UnitCalls {
 public:
  Third(const Package& package, Mode mode, const std::string& name, CallNote& note)
      : UnitCalls(note),
        library_(package.binary(interface_of(package.description(), mode)), note),
        f_(library_),
        values_(library_) {
    const std::string& token = package.description().token;
    const std::string resources = package.resources();
    if (mode == Mode::co_simulation) {
      library_.find(step_, "fmi3DoStep");
      decltype(fmi3InstantiateCoSimulation)* make;
      library_.find(make, "fmi3InstantiateCoSimulation");
      unit_ = call("fmi3InstantiateCoSimulation", make, name.c_str(), token.c_str(), resources.c_str(), false,
                   false, false, false, nullptr, 0, &log_, log, nullptr);
    } else {
      model_.emplace(library_);
      decltype(fmi3InstantiateModelExchange)* make;
      library_.find(make, "fmi3InstantiateModelExchange");
      unit_ = call("fmi3InstantiateModelExchange", make, name.c_str(), token.c_str(), resources.c_str(),
                   false, false, &log_, log);
    }
    if (!unit_)
      throw UnitError("its binary refuses to be instantiated" + (log_.empty() ? "" : ": " + log_.text()));
  }
  ~Third() override {
    if (started_ && !failed()) call("fmi3Terminate", f_.terminate, unit_);
    call("fmi3FreeInstance", f_.free_instance, unit_);
  }

  bool set_up(double start) override {
    return done("fmi3EnterInitializationMode", f_.enter_initialization, unit_, false, 0.0, start, false, 0.0);
  }
  bool initialize() override {
    return started_ = done("fmi3ExitInitializationMode", f_.exit_initialization, unit_);
  }
  bool get(Type type, const std::uint32_t* references, std::size_t count, void* values,
           std::size_t numbers) override {
    const std::size_t place = place_of(type);
    return done("a fmi3Get function", value_types[place].get, values_.get[place], unit_, references, count,
                values, numbers);
  }
  bool set(Type type, const std::uint32_t* references, std::size_t count, const void* values,
           std::size_t numbers) override {
    const std::size_t place = place_of(type);
    return done("a fmi3Set function", value_types[place].set, values_.set[place], unit_, references, count,
                values, numbers);
  }

  bool set_time(double time) override { return done("fmi3SetTime", model_->set_time, unit_, time); }
  bool set_states(const double* states, std::size_t count) override {
    return done("fmi3SetContinuousStates", model_->set_states, unit_, states, count);
  }
  bool get_states(double* states, std::size_t count) override {
    return done("fmi3GetContinuousStates", model_->get_states, unit_, states, count);
  }
  bool get_slopes(double* slopes, std::size_t count) override {
    return done("fmi3GetContinuousStateDerivatives", model_->get_slopes, unit_, slopes, count);
  }
  bool get_indicators(double* indicators, std::size_t count) override {
    return done("fmi3GetEventIndicators", model_->get_indicators, unit_, indicators, count);
  }
  bool complete_step(StepInfo& info) override {
    return done("fmi3CompletedIntegratorStep", model_->complete_step, unit_, true, &info.enters_event,
                &info.terminates);
  }
  bool enter_event() override { return done("fmi3EnterEventMode", model_->enter_event, unit_); }
  bool update(EventInfo& info) override {
    bool nominals = false;
    return done("fmi3UpdateDiscreteStates", model_->update, unit_, &info.again, &info.terminates, &nominals,
                &info.states_changed, &info.has_next, &info.next);
  }
  bool leave_event() override { return done("fmi3EnterContinuousTimeMode", model_->leave_event, unit_); }

  bool step(double time, double length, StepInfo& info) override {
    bool early = false;
    info.reached = time + length;
    return done("fmi3DoStep", step_, unit_, time, length, false, &info.enters_event, &info.terminates, &early,
                &info.reached) &&
           (!early || info.terminates || accept("fmi3DoStep, which returned early,", fmi3Discard));
  }

  std::size_t state_size() override {
    fmi3FMUState state = nullptr;
    std::size_t size = 0;
    const bool whole = done("fmi3GetFMUState", f_.get_state, unit_, &state) &&
                       done("fmi3SerializedFMUStateSize", f_.state_size, unit_, state, &size);
    if (state) call("fmi3FreeFMUState", f_.free_state, unit_, &state);
    return whole ? size : 0;
  }
  bool save(char* bytes, std::size_t count) override {
    fmi3FMUState state = nullptr;
    const bool whole =
        done("fmi3GetFMUState", f_.get_state, unit_, &state) &&
        done("fmi3SerializeFMUState", f_.serialize, unit_, state, reinterpret_cast<fmi3Byte*>(bytes), count);
    if (state) call("fmi3FreeFMUState", f_.free_state, unit_, &state);
    return whole;
  }
  bool load(const char* bytes, std::size_t count) override {
    fmi3FMUState state = nullptr;
    const bool whole = done("fmi3DeserializeFMUState", f_.deserialize, unit_,
                            reinterpret_cast<const fmi3Byte*>(bytes), count, &state) &&
                       done("fmi3SetFMUState", f_.set_state, unit_, state);
    if (state) call("fmi3FreeFMUState", f_.free_state, unit_, &state);
    return whole;
  }

 private:
  Library library_;
  Functions f_;
  ValueFunctions values_;
  std::optional<ModelFunctions> model_;
  decltype(fmi3DoStep)* step_ = nullptr;
  fmi3Instance unit_ = nullptr;
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Calls> instance_of_3(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note) {
  return std::make_unique<Third>(package, mode, name, note);
}

}  // namespace stepwire::fmi
