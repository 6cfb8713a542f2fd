#pragma once

#include <memory>
#include <string>
#include <vector>

#include "blocks/cosimulation/running_unit.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/file_path.hpp"

namespace stepwire {

/// FMU of version 2 or 3 whose variables are the block's ports: common part of both interfaces.
struct Fmu {
  static constexpr std::size_t most_ports = 1024;  ///< limit for inputs and for outputs
  enum class Interface { automatic, co_simulation, model_exchange };

  FilePath file{};
  Interface interface = Interface::automatic;
  Tree parameters{};
  bool isolate = true;
  std::vector<Input<>> inputs{};  ///< all connected inputs
  std::vector<Output<>> results{};
  DiscreteState<> unit_state{};   ///< bytes of the unit's state, as numbers; one if the unit cannot save it
  DiscreteState<1> unit_moves{};  ///< number of state changes of the unit
  Diagnostic unit_failed{}, unit_over{};
  Time t{};
  RunningUnit unit{};

  std::string reason() const { return unit.message(); }

 protected:
  /// Initialises the unit before the first tick.
  void begin();
  /// Copies the saved state of the unit into the state of the block.
  void keep();
  /// Passes the connected inputs to the unit.
  void hand_over();
  void show(const double* numbers);
  /// Restores the unit after the run was restored to an earlier state. Returns true if it did.
  bool follow();
  /// True once the unit has ended the run, after which no call is allowed.
  bool has_ended() const { return unit.works() && unit.exchange().ended != 0; }
  /// Counts a change of the unit's state, and stores its result.
  void settle();
};

/// FMU with its own solver, stepped from tick to tick.
struct SteppedFmu : Fmu {
  DiscreteState<> unit_outputs{};  ///< outputs after the last step
  Diagnostic beyond_step{};
  Period period{};

  void outputs();
  void update();
  void start();
  void configure(Configure& is);
  static void declare(Declare<SteppedFmu>& is);

 private:
  void judge_reached();
};

/// FMU whose states are integrated by the diagram's solver.
struct ContinuousFmu : Fmu {
  State<> unit_states{};
  DiscreteState<1> unit_event{};  ///< time of its next event [s]

  void outputs();
  void outputs_at_instant();
  void derivatives();
  void update();
  void update_at_event();
  void crossings(Crossings& zero) const;
  double next_edge() const;
  void start();
  void configure(Configure& is);
  static void declare(Declare<ContinuousFmu>& is);
  /// Returns the fault of the unit; where one of its events has passed between two ticks, with the cure.
  std::string reason() const;

 private:
  bool at_present(fmi::Operation operation) const;
  void act_early();
};

}  // namespace stepwire
