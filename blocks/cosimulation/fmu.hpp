#pragma once

#include <memory>
#include <string>
#include <vector>

#include "blocks/cosimulation/running_unit.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/file_path.hpp"

namespace stepwire {

/// A unit of FMI 2 or 3, whose variables are its ports: what both interfaces have in common.
struct Fmu {
  static constexpr std::size_t most_ports = 1024;  ///< inputs, and outputs
  enum class Interface { automatic, co_simulation, model_exchange };

  FilePath file{};
  Interface interface = Interface::automatic;
  Tree parameters{};
  bool isolate = true;
  std::vector<Input<>> inputs{};  ///< as many as are bound
  std::vector<Output<>> results{};
  DiscreteState<> unit_state{};   ///< bytes of the unit's state, as numbers; one where it cannot be saved
  DiscreteState<1> unit_moves{};  ///< how often the unit has moved on
  Diagnostic unit_failed{}, unit_over{};
  Time t{};
  RunningUnit unit{};

  std::string reason() const { return unit.message(); }

 protected:
  /// Before the first tick.
  void begin();
  /// Copies the state that the unit has saved into that of the block.
  void keep();
  /// Hands the inputs over that are wired.
  void hand_over();
  void show(const double* numbers);
  /// Puts the unit back to where the run was put back to.
  void follow();
  /// True once the unit has ended the run: no call may follow.
  bool has_ended() const { return unit.works() && unit.exchange().ended != 0; }
  /// Notes that the unit has moved on, and what became of it.
  void settle();
};

/// A unit that has its own solver: it goes from tick to tick.
struct SteppedFmu : Fmu {
  DiscreteState<> unit_outputs{};  ///< its outputs after the last step
  Period period{};

  void outputs();
  void update();
  void start();
  void configure(Configure& is);
  static void declare(Declare<SteppedFmu>& is);
};

/// A unit whose states our solvers integrate.
struct ContinuousFmu : Fmu {
  State<> unit_states{};
  DiscreteState<1> unit_event{};  ///< time of its next event [s]

  void outputs();
  void derivatives();
  void update();
  void update_at_event();
  void crossings(Crossings& zero) const;
  double next_edge() const;
  void start();
  void configure(Configure& is);
  static void declare(Declare<ContinuousFmu>& is);

 private:
  bool at_present(fmi::Operation operation) const;
};

}  // namespace stepwire
