#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

#include "engine/app/fmu/exported_unit.hpp"

namespace stepwire::fmu {

// Part of the sources of every exported unit, so it includes only the standard library.

/// Complete mutable state of a unit, as plain memory whose bytes are the FMU state. `Source` has Diagram, the
/// generated struct, and the table `variables`.
template <class Source>
struct MovingDiagram {
  using Diagram = typename Source::Diagram;

  explicit MovingDiagram(bool exchange) : exchange(exchange) {}

  Diagram diagram;
  typename Diagram::State before{};  ///< state before the last evaluation; co-simulation only
  double time = 0.0;                 ///< time of model exchange [s]
  double edge = std::numeric_limits<double>::infinity();  ///< next jump of a source [s], model exchange only
  std::int64_t first_tick = 0;
  Phase phase = Phase::made;
  bool exchange;
  bool evaluated = false;
  bool begins = true;           ///< true if evaluate() must first reset the diagram to its parameters
  bool inputs_written = false;  ///< false: the inputs follow from the parameters

  double now() const { return exchange ? time : diagram.time(); }

  /// Computes the outputs of the present instant unless they are up to date.
  void evaluate() {
    if (evaluated) return;
    if (begins) begin();
    if constexpr (requires(Diagram & d) { d.evaluate_at(0.0); })
      if (exchange) evaluate_exchange();
    if (!exchange) {
      diagram.save(before);
      diagram.evaluate();
    }
    evaluated = true;
  }

  /// Invalidates the outputs after an input or a parameter was written. Restores the state before the
  /// evaluation, so that memory which blocks updated in it is not used twice.
  void forget() {
    if (evaluated && !exchange) static_cast<void>(diagram.restore(before));
    evaluated = false;
  }

  void advance() {
    diagram.advance();
    evaluated = false;
  }

  /// Returns the k-th number of a variable. FMI counts a matrix by rows, the diagram stores it by columns.
  double& number(const UnitVariable& variable, int k) {
    double* first = variable.place(&diagram);
    const int columns = variable.size / variable.rows;
    return first[variable.rows == 1 ? k : k % columns * variable.rows + k / columns];
  }

  /// Reads the numbers of variables; evaluate() must precede.
  void read(References references, double* values) {
    for (std::size_t i = 0; i < references.count; ++i) {
      const UnitVariable& variable = Source::variables[references.of[i]];
      for (int k = 0; k < variable.size; ++k)
        *values++ = variable.kind == Kind::time        ? now()
                    : variable.kind == Kind::indicator ? crossing(k)
                                                       : number(variable, k);
    }
  }

  void write(References references, const double* values) {
    forget();
    for (std::size_t i = 0; i < references.count; ++i) {
      const UnitVariable& variable = Source::variables[references.of[i]];
      inputs_written |= variable.kind == Kind::input;
      for (int k = 0; k < variable.size; ++k) number(variable, k) = *values++;
    }
  }

 private:
  /// Branches are chosen at events alone: a step of the importer's solver never sees both sides of one.
  void evaluate_exchange() {
    if constexpr (requires(Diagram & d) { d.evaluate_between(0.0, 0.0); })
      if (phase == Phase::continuous) return diagram.evaluate_between(time, edge);
    diagram.evaluate_at(time);
  }

  double crossing(int k) {
    if constexpr (requires(Diagram & d) { d.crossings(nullptr); }) {
      double numbers[Diagram::crossing_count];
      diagram.crossings(numbers);
      return numbers[k];
    }
    return 0.0;
  }

  void begin() {
    if constexpr (requires(Diagram & d) { d.inputs; }) {
      const auto inputs = diagram.inputs;
      diagram.reset();
      if (inputs_written) diagram.inputs = inputs;
    } else {
      diagram.reset();
    }
    diagram.tick = first_tick;
    begins = false;
  }
};

// Part of the sources of every exported unit, so it includes only the standard library.

/// Directional derivatives of a diagram by central differences.
/// Each known number with a nonzero seed is perturbed in a copy of the diagram, which is evaluated on both
/// sides. So the diagram itself keeps its bytes. Cost: two evaluations for each such number.
template <class Source>
class Difference {
  using Moving = MovingDiagram<Source>;

 public:
  Difference(const Moving& at, References unknowns, std::size_t numbers)
      : at_(at),
        unknowns_(unknowns),
        count_(numbers),
        trial_(new (std::nothrow) Moving(at)),
        high_(new (std::nothrow) double[numbers + 1]),
        low_(new (std::nothrow) double[numbers + 1]) {}

  /// Writes to `sum` the derivatives by all known numbers, weighted by their seeds. False if memory
  /// allocation failed.
  bool add_all(References knowns, const double* seed, double* sum) {
    if (!trial_ || !high_ || !low_) return false;
    std::fill_n(sum, count_, 0.0);
    for (std::size_t i = 0; i < knowns.count; ++i) {
      const UnitVariable& known = Source::variables[knowns.of[i]];
      for (int k = 0; k < known.size; ++k, ++seed)
        if (*seed != 0.0) add(known, k, *seed, sum);
    }
    return true;
  }

 private:
  void add(const UnitVariable& known, int k, double seed, double* sum) {
    // Relative step, the cube root of the machine epsilon, and the smallest magnitude that it refers to.
    constexpr double part = 6e-6, least = 1e-3;
    look(known, k, 0.0, nullptr);
    const double x = trial_->number(known, k);
    const double h = part * std::fmax(std::fabs(x), least), above = x + h, below = x - h;
    look(known, k, above, high_.get());
    look(known, k, below, low_.get());
    for (std::size_t j = 0; j < count_; ++j) sum[j] += seed * ((high_[j] - low_[j]) / (above - below));
  }

  /// Resets the copy and reads the unknowns after setting a known number. With `values` nullptr it only
  /// resets.
  void look(const UnitVariable& known, int k, double value, double* values) {
    std::memcpy(static_cast<void*>(trial_.get()), &at_, sizeof at_);
    if (!values) return;
    trial_->forget();
    trial_->number(known, k) = value;
    trial_->evaluate();
    trial_->read(unknowns_, values);
  }

  const Moving& at_;
  References unknowns_;
  std::size_t count_;
  std::unique_ptr<Moving> trial_;
  std::unique_ptr<double[]> high_, low_;
};

// Part of the sources of every exported unit, so it includes only the standard library.

/// Unit of a generated diagram. `Source` has: Diagram, the generated struct; step [s]; layout, the key of its
/// saved states; variables and their count.
template <class Source>
class DiagramUnit final : public ExportedUnit {
  using Diagram = typename Source::Diagram;
  using Moving = MovingDiagram<Source>;
  static_assert(std::is_trivially_copyable_v<Moving> && std::is_trivially_destructible_v<Moving>);
  static constexpr bool can_exchange = requires(Diagram & d) { d.evaluate_at(0.0); };

 public:
  DiagramUnit(bool exchange, void* caller, Log log) : ExportedUnit(caller, log), moving_(exchange) {}

  Phase phase() const override { return moving_.phase; }
  bool exchanges() const override { return moving_.exchange; }
  std::size_t state_count() const override {
    if constexpr (can_exchange) return Diagram::state_count;
    return 0;
  }
  std::size_t crossing_count() const override {
    if constexpr (requires(Diagram & d) { d.crossings(nullptr); }) return Diagram::crossing_count;
    return 0;
  }

  Status enter_initialization(double start) override {
    if (!allows(0u | Phase::made, "EnterInitializationMode")) return Status::error;
    const double ticks = std::round(start / Source::step);
    constexpr double most = 9007199254740992.0;  // 2^53, up to which each whole number is a double
    if (!(std::fabs(ticks - start / Source::step) < near) || ticks < 0.0 || ticks > most)
      return refuse("it cannot begin at %g s, which is no whole number of its steps of %g s", start,
                    Source::step);
    moving_.first_tick = static_cast<std::int64_t>(ticks);
    moving_.time = start;
    moving_.phase = Phase::initializing;
    return Status::ok;
  }
  Status leave_initialization() override {
    if (!allows(0u | Phase::initializing, "ExitInitializationMode")) return Status::error;
    moving_.evaluate();
    moving_.phase = moving_.exchange ? Phase::at_event : Phase::stepping;
    return Status::ok;
  }
  Status terminate() override {
    if (!allows(Phase::at_event | Phase::continuous | Phase::stepping, "Terminate")) return Status::error;
    if (moving_.phase == Phase::stepping && look_at_end() != Status::ok) return Status::error;
    moving_.phase = Phase::ended;
    return Status::ok;
  }
  Status reset() override {
    const bool exchange = moving_.exchange;
    ::new (static_cast<void*>(&moving_)) Moving(exchange);
    return Status::ok;
  }

  Status get(References references, double* values, std::size_t numbers) override {
    constexpr unsigned phases = Phase::initializing | Phase::at_event | Phase::continuous | Phase::stepping |
                                Phase::ended | Phase::failed;
    if (!allows(phases, "a Get function",
                {{"valueReferences", references.of, references.count}, {"values", values, numbers}}) ||
        !fit(references, numbers))
      return Status::error;
    moving_.evaluate();
    moving_.read(references, values);
    return Status::ok;
  }

  Status set(References references, const double* values, std::size_t numbers) override {
    constexpr unsigned phases =
        Phase::made | Phase::initializing | Phase::at_event | Phase::continuous | Phase::stepping;
    if (!allows(phases, "a Set function",
                {{"valueReferences", references.of, references.count}, {"values", values, numbers}}) ||
        !fit(references, numbers))
      return Status::error;
    bool parameters = false;
    for (std::size_t i = 0; i < references.count; ++i) {
      const UnitVariable& variable = Source::variables[references.of[i]];
      if (variable.kind != Kind::parameter && variable.kind != Kind::input)
        return refuse("%s is neither an input nor a parameter, and cannot be set", variable.name);
      parameters |= variable.kind == Kind::parameter;
    }
    if (parameters && phase() == Phase::continuous)
      return refuse("a parameter can be set in event mode, not in continuous-time mode");
    if (parameters) return set_parameters(references, values);
    moving_.write(references, values);
    return Status::ok;
  }

  Status derivative(References unknowns, References knowns, const double* seed, std::size_t seeds,
                    double* sensitivity, std::size_t sensitivities) override;
  Status step(double time, double length, StepEnd& end) override;

  Status set_time(double time) override {
    if (!allows(Phase::at_event | Phase::continuous, "SetTime")) return Status::error;
    moving_.time = time;
    moving_.evaluated = false;
    return Status::ok;
  }
  Status set_states(const double* states, std::size_t count) override {
    if (!allows(Phase::at_event | Phase::continuous, "SetContinuousStates",
                {{"continuousStates", states, count}}) ||
        !are_states(count))
      return Status::error;
    if constexpr (can_exchange)
      std::memcpy(moving_.diagram.continuous_states(), states, count * sizeof *states);
    moving_.evaluated = false;
    return Status::ok;
  }
  Status get_states(double* states, std::size_t count) override {
    if (!allows(looked_at, "GetContinuousStates", {{"continuousStates", states, count}}) ||
        !are_states(count))
      return Status::error;
    moving_.evaluate();
    if constexpr (can_exchange)
      std::memcpy(states, moving_.diagram.continuous_states(), count * sizeof *states);
    return Status::ok;
  }
  Status get_nominals(double* nominals, std::size_t count) override {
    if (!given("GetNominalsOfContinuousStates", {{"nominals", nominals, count}}) || !are_states(count))
      return Status::error;
    std::fill_n(nominals, count, 1.0);
    return Status::ok;
  }
  Status get_slopes(double* slopes, std::size_t count) override {
    if (!allows(looked_at, "a call for derivatives", {{"derivatives", slopes, count}}) || !are_states(count))
      return Status::error;
    moving_.evaluate();
    if constexpr (can_exchange) std::memcpy(slopes, moving_.diagram.slopes(), count * sizeof *slopes);
    return Status::ok;
  }
  Status get_crossings(double* numbers, std::size_t count) override {
    if (!allows(looked_at, "GetEventIndicators", {{"eventIndicators", numbers, count}})) return Status::error;
    if (count != crossing_count())
      return refuse("it has %zu event indicators, not %zu", crossing_count(), count);
    moving_.evaluate();
    if constexpr (requires(Diagram & d) { d.crossings(numbers); }) moving_.diagram.crossings(numbers);
    // The distance to a limit that does not exist is infinite, which FMI does not allow.
    for (std::size_t i = 0; i < count; ++i)
      if (std::isinf(numbers[i])) numbers[i] = std::copysign(1.0, numbers[i]);
    return Status::ok;
  }
  Status complete_step(bool& terminates) override {
    if (!allows(0u | Phase::continuous, "CompletedIntegratorStep")) return Status::error;
    moving_.evaluate();
    if constexpr (can_exchange) moving_.diagram.complete_step();
    terminates = moving_.diagram.stops();
    return sound(true);
  }
  Status enter_event() override {
    if (!allows(Phase::continuous | Phase::at_event, "EnterEventMode")) return Status::error;
    moving_.phase = Phase::at_event;
    moving_.evaluated = false;
    return Status::ok;
  }
  Status update(bool& terminates, double& next) override {
    if (!allows(0u | Phase::at_event, "a call for discrete states")) return Status::error;
    moving_.evaluate();
    terminates = moving_.diagram.stops();
    if constexpr (requires(Diagram & d) { d.next_edge(); }) moving_.edge = moving_.diagram.next_edge();
    next = moving_.edge;
    return Status::ok;
  }
  Status leave_event() override {
    if (!allows(0u | Phase::at_event, "EnterContinuousTimeMode")) return Status::error;
    moving_.phase = Phase::continuous;
    return Status::ok;
  }

  std::size_t state_bytes() const override { return sizeof(std::uint64_t) + sizeof moving_; }
  void save(void* bytes) const override {
    const std::uint64_t key = state_key();
    std::memcpy(bytes, &key, sizeof key);
    std::memcpy(static_cast<char*>(bytes) + sizeof key, &moving_, sizeof moving_);
  }
  Status check_state(const void* bytes, std::size_t count) override {
    const std::uint64_t key = state_key();
    const bool same = count == state_bytes() && std::memcmp(bytes, &key, sizeof key) == 0;
    return same ? Status::ok : refuse("this is no state of this unit with this interface");
  }
  Status load(const void* bytes) override {
    if (check_state(bytes, state_bytes()) != Status::ok) return Status::error;
    std::memcpy(static_cast<void*>(&moving_), static_cast<const char*>(bytes) + sizeof(std::uint64_t),
                sizeof moving_);
    return Status::ok;
  }

 private:
  static constexpr double near = 1e-3;  // tolerance of a time, as a fraction of a step, for rounding
  static constexpr unsigned looked_at =
      Phase::initializing | Phase::at_event | Phase::continuous | Phase::ended;

  std::uint64_t state_key() const { return Source::layout ^ (moving_.exchange ? 1u : 0u); }

  bool fit(References references, std::size_t numbers) {
    std::size_t own = 0;
    for (std::size_t i = 0; i < references.count; ++i) {
      if (references.of[i] >= Source::count)
        return refuse("it has no variable with the value reference %u", references.of[i]) == Status::ok;
      own += static_cast<std::size_t>(Source::variables[references.of[i]].size);
    }
    return own == numbers || refuse("these variables are %zu numbers, not %zu", own, numbers) == Status::ok;
  }
  bool are_states(std::size_t count) {
    if (!moving_.exchange) return refuse("it was made for co-simulation, and shows no states") == Status::ok;
    return count == state_count() ||
           refuse("it has %zu continuous states, not %zu", state_count(), count) == Status::ok;
  }

  Status set_parameters(References references, const double* values) {
    if constexpr (requires(Diagram & d) { d.parameters; }) {
      const auto former = moving_.diagram.parameters;
      moving_.write(references, values);
      if (const char* why = moving_.diagram.check(moving_.diagram.parameters)) {
        moving_.diagram.parameters = former;
        return refuse("%s", why);
      }
    }
    moving_.begins |= phase() == Phase::made || phase() == Phase::initializing;
    return Status::ok;
  }

  /// Fails if a block refuses the last instant, after which no step follows.
  Status look_at_end() {
    moving_.evaluate();
    if (!moving_.diagram.stops()) moving_.diagram.look_at_end();
    return sound(true);
  }

  /// Fails if a signal or state is not finite or, after a step, if a block has reported a fault.
  Status sound(bool stepped) {
    const char* why = moving_.diagram.finite() ? nullptr : "a signal or a state is no finite number";
    if (!why && stepped) why = moving_.diagram.fault();
    if (!why) return Status::ok;
    moving_.phase = Phase::failed;
    return refuse("%s, at %g s", why, moving_.now());
  }

  Moving moving_;
};

template <class Source>
Status DiagramUnit<Source>::step(double time, double length, StepEnd& end) {
  if (!allows(0u | Phase::stepping, "DoStep")) return Status::error;
  const double ticks = std::round(length / Source::step);
  moving_.evaluate();
  end = {moving_.diagram.stops(), true, moving_.now()};
  if (!(std::fabs(time - end.last) < near * Source::step) && !end.terminates)
    return refuse("it stands at %.17g s, and no step can begin at %.17g s", end.last, time);
  if (!(std::fabs(ticks - length / Source::step) < near) || ticks < 1.0)
    return refuse("%g s is no whole number of its steps of %g s", length, Source::step);
  for (double tick = 0.0; tick < ticks; ++tick) {
    if (end.terminates) {
      end.whole = false;
      break;
    }
    moving_.advance();
    if (sound(true) != Status::ok) return Status::error;
    moving_.evaluate();
    if (sound(false) != Status::ok) return Status::error;
    end = {moving_.diagram.stops(), true, moving_.now()};
  }
  return Status::ok;
}

template <class Source>
Status DiagramUnit<Source>::derivative(References unknowns, References knowns, const double* seed,
                                       std::size_t seeds, double* sensitivity, std::size_t sensitivities) {
  constexpr unsigned phases = Phase::initializing | Phase::at_event | Phase::continuous | Phase::stepping;
  const bool allowed = allows(phases, "GetDirectionalDerivative",
                              {{"unknowns", unknowns.of, unknowns.count},
                               {"knowns", knowns.of, knowns.count},
                               {"seed", seed, seeds},
                               {"sensitivity", sensitivity, sensitivities}});
  if (!allowed || !fit(unknowns, sensitivities) || !fit(knowns, seeds)) return Status::error;
  for (std::size_t i = 0; i < knowns.count; ++i) {
    const UnitVariable& known = Source::variables[knowns.of[i]];
    if (known.kind != Kind::input && !(known.kind == Kind::state && moving_.exchange))
      return refuse("%s is neither an input nor a continuous state", known.name);
  }
  moving_.evaluate();
  Difference<Source> difference(moving_, unknowns, sensitivities);
  return difference.add_all(knowns, seed, sensitivity) ? Status::ok
                                                       : refuse("there is no memory for a derivative");
}

}  // namespace stepwire::fmu
