#include "engine/base/fmi/calls.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/base/fmi/fmi2.h"
#include "engine/base/fmi/fmi3.h"
#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/subprocess/fork.hpp"

namespace stepwire::fmi {

namespace {

/// A loaded binary. Loading and unloading run foreign code.
class Library {
 public:
  /// Loads a binary. Throws UnitError with the linker's reason.
  Library(const std::string& file, CallNote& note);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Sets a pointer to the function of this name. Throws UnitError if it is missing.
  template <class Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }
  /// Sets a pointer to the function of this name; nullptr if it is missing.
  template <class Function>
  void find_if_there(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address_if_there(name));
  }

 private:
  void* address(const char* name) const;
  void* address_if_there(const char* name) const;

  CallNote& note_;
  void* handle_;
};

// A guarded call, since code compiled with -ffast-math sets flush-to-zero on loading.
void* load(const std::string& file, CallNote& note) {
  const std::lock_guard lock(subprocess::loader_mutex());
  const ForeignCall call(note, "the loading of its binary");
  return dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
}

Library::Library(const std::string& file, CallNote& note) : note_(note), handle_(load(file, note)) {
  if (!handle_) throw UnitError(fmt::format("its binary cannot be loaded: {}", dlerror()));
}

Library::~Library() {
  const std::lock_guard lock(subprocess::loader_mutex());
  const ForeignCall call(note_, "the unloading of its binary");
  dlclose(handle_);
}

void* Library::address_if_there(const char* name) const {
  return dlsym(handle_, name);
}

void* Library::address(const char* name) const {
  void* found = address_if_there(name);
  if (!found) throw UnitError(fmt::format("its binary has no function {}", name));
  return found;
}

/// Last fault message that a unit has logged. Storing one does not allocate.
class LogText {
 public:
  void take(const char* text) {
    std::size_t length = 0;
    for (; text && text[length] && length + 1 < sizeof text_; ++length) {
      const auto byte = static_cast<unsigned char>(text[length]);
      text_[length] = byte < 0x20 || byte == 0x7f ? ' ' : text[length];
    }
    while (length > 0 && text_[length - 1] == ' ') --length;
    text_[length] = '\0';
  }
  void clear() { text_[0] = '\0'; }
  bool empty() const { return text_[0] == '\0'; }
  std::string text() const { return text_; }

 private:
  char text_[400] = "";
};

/// True for the fault statuses and for numbers that the standard does not define. Discard is a fault.
constexpr bool is_fault(int status) {
  return status < 0 || status >= 2;
}

void log_of_2(fmi2ComponentEnvironment log, fmi2String, fmi2Status status, fmi2String, fmi2String message,
              ...) {
  const UsualFloatingPoint ours;
  if (!is_fault(static_cast<int>(status))) return;
  char text[400];
  va_list values;
  va_start(values, message);
  std::vsnprintf(text, sizeof text, message, values);
  va_end(values);
  static_cast<LogText*>(log)->take(text);
}

void log_of_3(fmi3InstanceEnvironment log, fmi3Status status, fmi3String, fmi3String message) {
  const UsualFloatingPoint ours;
  if (is_fault(static_cast<int>(status))) static_cast<LogText*>(log)->take(message);
}

/// Function of a binary, and its name in the standard.
template <class Signature>
struct Function {
  Function() = default;
  /// Finds the function if it is needed. Throws UnitError if it is missing.
  Function(const Library& library, const std::string& name, bool needed = true) : name(name) {
    if (needed) library.find(address, name.c_str());
  }

  std::string name{};
  Signature* address = nullptr;
};

using AnyFunction = Function<void()>;

/// Value type of a version: the suffix of its function names, and typed calls of its getter and setter, which
/// return the status. The name is nullptr for a type that the version does not have.
struct ValueType {
  const char* name = nullptr;
  int (*get)(const AnyFunction&, void* unit, const std::uint32_t*, std::size_t, void*, std::size_t) = nullptr;
  int (*set)(const AnyFunction&, void* unit, const std::uint32_t*, std::size_t, const void*,
             std::size_t) = nullptr;
};

template <class Version, class Value, class Values>
int transfer(const AnyFunction& function, void* unit, const std::uint32_t* references, std::size_t count,
             Values* values, [[maybe_unused]] std::size_t numbers) {
  const auto call = [&](auto... count_of_numbers) {
    using Transfer = typename Version::Status (*)(void*, const std::uint32_t*, std::size_t, Value*,
                                                  decltype(count_of_numbers)...);
    return reinterpret_cast<Transfer>(function.address)(unit, references, count, static_cast<Value*>(values),
                                                        count_of_numbers...);
  };
  if constexpr (Version::counts_numbers)
    return static_cast<int>(call(numbers));
  else
    return static_cast<int>(call());
}

template <class Version, class Value>
constexpr ValueType value_type(const char* name) {
  return {name, &transfer<Version, Value, void>, &transfer<Version, const Value, const void>};
}

/// Types and names of FMI 2 that differ from those of FMI 3. The value types are in the order of Type.
struct Fmi2 {
  using Status = fmi2Status;
  using Boolean = fmi2Boolean;
  using Byte = fmi2Byte;
  static constexpr const char *prefix = "fmi2", *state = "FMUstate", *deserialize = "DeSerialize",
                              *get_slopes = "GetDerivatives";
  static constexpr bool counts_numbers = false;
  static const ValueType value_types[12];
};
struct Fmi3 {
  using Status = fmi3Status;
  using Boolean = fmi3Boolean;
  using Byte = fmi3Byte;
  static constexpr const char *prefix = "fmi3", *state = "FMUState", *deserialize = "Deserialize",
                              *get_slopes = "GetContinuousStateDerivatives";
  static constexpr bool counts_numbers = true;
  static const ValueType value_types[12];
};

const ValueType Fmi2::value_types[] = {
    value_type<Fmi2, fmi2Real>("Real"),       {}, {}, {}, {}, {},
    value_type<Fmi2, fmi2Integer>("Integer"), {}, {}, {}, {}, value_type<Fmi2, fmi2Boolean>("Boolean")};
const ValueType Fmi3::value_types[] = {
    value_type<Fmi3, fmi3Float64>("Float64"), value_type<Fmi3, fmi3Float32>("Float32"),
    value_type<Fmi3, fmi3Int8>("Int8"),       value_type<Fmi3, fmi3UInt8>("UInt8"),
    value_type<Fmi3, fmi3Int16>("Int16"),     value_type<Fmi3, fmi3UInt16>("UInt16"),
    value_type<Fmi3, fmi3Int32>("Int32"),     value_type<Fmi3, fmi3UInt32>("UInt32"),
    value_type<Fmi3, fmi3Int64>("Int64"),     value_type<Fmi3, fmi3UInt64>("UInt64"),
    value_type<Fmi3, fmi3Boolean>("Boolean"), {}};

/// Calls that both versions have in common. All calls into a unit are made by call().
template <class Version>
class UnitCalls : public Calls {
 public:
  bool initialize() override { return started_ = done(exit_initialization_, unit_); }
  bool get(Type type, const std::uint32_t* references, std::size_t count, void* values,
           std::size_t numbers) override {
    const auto at = static_cast<std::size_t>(type);
    return transferred(get_[at], Version::value_types[at].get, references, count, values, numbers);
  }
  bool set(Type type, const std::uint32_t* references, std::size_t count, const void* values,
           std::size_t numbers) override {
    const auto at = static_cast<std::size_t>(type);
    return transferred(set_[at], Version::value_types[at].set, references, count, values, numbers);
  }

  bool set_time(double time) override { return done(set_time_, unit_, time); }
  bool set_states(const double* states, std::size_t count) override {
    return done(set_states_, unit_, states, count);
  }
  bool get_states(double* states, std::size_t count) override {
    return done(get_states_, unit_, states, count);
  }
  bool get_slopes(double* slopes, std::size_t count) override {
    return done(get_slopes_, unit_, slopes, count);
  }
  bool get_indicators(double* indicators, std::size_t count) override {
    return done(get_indicators_, unit_, indicators, count);
  }
  bool complete_step(StepInfo& info) override {
    Boolean enters = false, ends = false;
    const bool whole = done(complete_step_, unit_, Boolean{true}, &enters, &ends);
    info.terminates = ends != Boolean{false};
    info.enters_event = enters != Boolean{false};
    return whole;
  }
  bool enter_event() override { return done(enter_event_, unit_); }
  bool leave_event() override { return done(leave_event_, unit_); }

  std::size_t state_size() override {
    void* state = nullptr;
    std::size_t size = 0;
    const bool whole = done(get_state_, unit_, &state) && done(state_size_, unit_, state, &size);
    return released(state, whole) ? size : 0;
  }
  bool save(char* bytes, std::size_t count) override {
    void* state = nullptr;
    return released(state, done(get_state_, unit_, &state) &&
                               done(serialize_, unit_, state, reinterpret_cast<Byte*>(bytes), count));
  }
  bool load(const char* bytes, std::size_t count) override {
    void* state = nullptr;
    return released(state, done(deserialize_, unit_, reinterpret_cast<const Byte*>(bytes), count, &state) &&
                               done(set_state_, unit_, state));
  }

  std::string message() const override { return log_.empty() ? fault_.text() : log_.text(); }

 protected:
  using Boolean = typename Version::Boolean;
  using Byte = typename Version::Byte;
  template <class... Arguments>
  using Call = Function<typename Version::Status(void* unit, Arguments...)>;

  UnitCalls(const Package& package, Mode mode, CallNote& note)
      : note_(note),
        exchange_(mode == Mode::model_exchange),
        library_(package.binary(interface_of(package.description(), mode)), note) {
    for (std::size_t i = 0; i < std::size(get_); ++i) {
      const char* type = Version::value_types[i].name;
      if (!type) continue;
      get_[i] = {library_, name("Get") + type};
      set_[i] = {library_, name("Set") + type};
    }
  }
  /// Keeps a new instance. Throws UnitError for nullptr.
  void own(void* unit) {
    unit_ = unit;
    if (!unit_)
      throw UnitError("its binary refuses to be instantiated" + (log_.empty() ? "" : ": " + log_.text()));
  }
  void free_unit() {
    if (started_ && !failed_) call(terminate_, unit_);
    call(free_instance_, unit_);
  }

  template <class Signature, class... Arguments>
  auto call(const Function<Signature>& function, Arguments... arguments) {
    const ForeignCall call(note_, function.name.c_str());
    return function.address(arguments...);
  }
  /// Calls a function that returns a status. Returns false for a fault and for an undefined status.
  template <class Signature, class... Arguments>
  bool done(const Function<Signature>& function, Arguments... arguments) {
    return accept(function.name.c_str(), static_cast<int>(call(function, arguments...)));
  }
  /// Records a status; false for a fault.
  bool accept(const char* name, int status) {
    if (!is_fault(status)) return true;
    failed_ = true;
    const bool known = status > 0 && status <= fmi2Pending;
    char text[200];  // a buffer on the stack, since a run must not allocate
    if (known)
      std::snprintf(text, sizeof text, "%s failed, and the unit gives no reason", name);
    else
      std::snprintf(text, sizeof text, "%s returned the status %d, which FMI does not have", name, status);
    if (!known) log_.clear();
    fault_.take(text);
    return false;
  }

  CallNote& note_;
  LogText log_{}, fault_{};
  const bool exchange_;
  bool failed_ = false, started_ = false;
  void* unit_ = nullptr;
  Library library_;

 private:
  static std::string name(const std::string& rest) { return Version::prefix + rest; }
  static std::string of_state(const char* before, const char* after = "") {
    return name(before) + Version::state + after;
  }

  template <class Transfer, class Values>
  bool transferred(const AnyFunction& function, Transfer* transfer, const std::uint32_t* references,
                   std::size_t count, Values* values, std::size_t numbers) {
    int status = 0;
    {
      const ForeignCall call(note_, function.name.c_str());
      status = transfer(function, unit_, references, count, values, numbers);
    }
    return accept(function.name.c_str(), status);
  }
  bool released(void* state, bool whole) {
    if (state) call(free_state_, unit_, &state);
    return whole;
  }

  Function<void(void*)> free_instance_{library_, name("FreeInstance")};
  Call<> exit_initialization_{library_, name("ExitInitializationMode")};
  Call<> terminate_{library_, name("Terminate")};
  Call<void**> get_state_{library_, of_state("Get")}, free_state_{library_, of_state("Free")};
  Call<void*> set_state_{library_, of_state("Set")};
  Call<void*, std::size_t*> state_size_{library_, of_state("Serialized", "Size")};
  Call<void*, Byte*, std::size_t> serialize_{library_, of_state("Serialize")};
  Call<const Byte*, std::size_t, void**> deserialize_{library_, of_state(Version::deserialize)};
  AnyFunction get_[12], set_[12];  ///< by Type

  // Model exchange only.
  Call<double> set_time_{library_, name("SetTime"), exchange_};
  Call<const double*, std::size_t> set_states_{library_, name("SetContinuousStates"), exchange_};
  Call<double*, std::size_t> get_states_{library_, name("GetContinuousStates"), exchange_},
      get_slopes_{library_, name(Version::get_slopes), exchange_},
      get_indicators_{library_, name("GetEventIndicators"), exchange_};
  Call<Boolean, Boolean*, Boolean*> complete_step_{library_, name("CompletedIntegratorStep"), exchange_};
  Call<> enter_event_{library_, name("EnterEventMode"), exchange_};
  Call<> leave_event_{library_, name("EnterContinuousTimeMode"), exchange_};
};

class CallsOf2 : public UnitCalls<Fmi2> {
 public:
  CallsOf2(const Package& package, Mode mode, const std::string& name, CallNote& note)
      : UnitCalls(package, mode, note) {
    const Function<decltype(fmi2Instantiate)> make(library_, "fmi2Instantiate");
    if (!exchange_) library_.find_if_there(get_real_status_.address, "fmi2GetRealStatus");
    own(call(make, name.c_str(), exchange_ ? fmi2ModelExchange : fmi2CoSimulation,
             package.description().token.c_str(), package.resources_uri().c_str(), &callbacks_, fmi2False,
             fmi2False));
  }
  ~CallsOf2() override { free_unit(); }

  bool set_up(double start) override {
    return done(set_up_, unit_, fmi2False, 0.0, start, fmi2False, 0.0) && done(enter_initialization_, unit_);
  }
  bool update(EventInfo& info) override {
    fmi2EventInfo found{};
    const bool whole = done(update_, unit_, &found);
    info = {found.newDiscreteStatesNeeded != fmi2False, found.terminateSimulation != fmi2False,
            found.valuesOfContinuousStatesChanged != fmi2False, found.nextEventTimeDefined != fmi2False,
            found.nextEventTime};
    return whole;
  }
  bool step(double time, double length, StepInfo& info) override {
    const int status = static_cast<int>(call(step_, unit_, time, length, fmi2False));
    info.terminates = status == fmi2Discard && wants_end();
    info.reached = info.terminates ? std::max(time, last_successful_time(time)) : time + length;
    info.made = !info.terminates || info.reached > time;
    return info.terminates || accept("fmi2DoStep", status);
  }

 private:
  /// Returns the last successful time of a discarded step; `before` if the unit does not provide it.
  double last_successful_time(double before) {
    fmi2Real reached = before;
    if (!get_real_status_.address) return before;
    return call(get_real_status_, unit_, fmi2LastSuccessfulTime, &reached) == fmi2OK ? reached : before;
  }
  /// True where the unit discarded the step in order to end the run.
  bool wants_end() {
    fmi2Boolean terminated = fmi2False;
    return call(get_boolean_status_, unit_, fmi2Terminated, &terminated) == fmi2OK && terminated != fmi2False;
  }

  fmi2CallbackFunctions callbacks_{log_of_2, std::calloc, std::free, nullptr, &log_};
  Function<decltype(fmi2SetupExperiment)> set_up_{library_, "fmi2SetupExperiment"};
  Function<decltype(fmi2EnterInitializationMode)> enter_initialization_{library_,
                                                                        "fmi2EnterInitializationMode"};
  Function<decltype(fmi2NewDiscreteStates)> update_{library_, "fmi2NewDiscreteStates", exchange_};
  Function<decltype(fmi2DoStep)> step_{library_, "fmi2DoStep", !exchange_};
  Function<decltype(fmi2GetBooleanStatus)> get_boolean_status_{library_, "fmi2GetBooleanStatus", !exchange_};
  Function<decltype(fmi2GetRealStatus)> get_real_status_{library_, "fmi2GetRealStatus", false};
};

class CallsOf3 : public UnitCalls<Fmi3> {
 public:
  CallsOf3(const Package& package, Mode mode, const std::string& name, CallNote& note)
      : UnitCalls(package, mode, note) {
    const std::string& token = package.description().token;
    const std::string resources = package.resources();
    const Function<decltype(fmi3InstantiateCoSimulation)> make_stepping(
        library_, "fmi3InstantiateCoSimulation", !exchange_);
    const Function<decltype(fmi3InstantiateModelExchange)> make_exchanging(
        library_, "fmi3InstantiateModelExchange", exchange_);
    own(exchange_ ? call(make_exchanging, name.c_str(), token.c_str(), resources.c_str(), false, false, &log_,
                         log_of_3)
                  : call(make_stepping, name.c_str(), token.c_str(), resources.c_str(), false, false, false,
                         false, nullptr, 0, &log_, log_of_3, nullptr));
  }
  ~CallsOf3() override { free_unit(); }

  bool set_up(double start) override {
    return done(enter_initialization_, unit_, false, 0.0, start, false, 0.0);
  }
  bool update(EventInfo& info) override {
    bool nominals = false;
    return done(update_, unit_, &info.again, &info.terminates, &nominals, &info.states_changed,
                &info.has_next, &info.next);
  }
  bool step(double time, double length, StepInfo& info) override {
    bool early = false;
    info.reached = time + length;
    return done(step_, unit_, time, length, false, &info.enters_event, &info.terminates, &early,
                &info.reached) &&
           (!early || info.terminates || accept("fmi3DoStep, which returned early,", fmi3Discard));
  }

 private:
  Function<decltype(fmi3EnterInitializationMode)> enter_initialization_{library_,
                                                                        "fmi3EnterInitializationMode"};
  Function<decltype(fmi3UpdateDiscreteStates)> update_{library_, "fmi3UpdateDiscreteStates", exchange_};
  Function<decltype(fmi3DoStep)> step_{library_, "fmi3DoStep", !exchange_};
};

}  // namespace

std::unique_ptr<Calls> instantiate(const Package& package, Mode mode, const std::string& name,
                                   CallNote& note) {
  if (package.description().version == 2) return std::make_unique<CallsOf2>(package, mode, name, note);
  return std::make_unique<CallsOf3>(package, mode, name, note);
}

const Interface& interface_of(const Description& description, Mode mode) {
  return mode == Mode::co_simulation ? description.co_simulation : description.model_exchange;
}

}  // namespace stepwire::fmi
