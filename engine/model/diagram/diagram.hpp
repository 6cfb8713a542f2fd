#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/every.hpp"
#include "engine/model/diagram/sweep.hpp"

namespace stepwire::diagram {

struct Binding;
struct Bindings;

/// Units of ports, [block][port], where known.
using PortUnits = std::vector<std::vector<std::optional<unit::Dimension>>>;

/// An output whose elements have different units.
struct ElementDimensions {
  int block = -1, output = -1;
  std::vector<std::optional<unit::Dimension>> each;
};

/// A file as it is used at one place of a diagram: the diagram itself (scope 0), or a part inside of it.
struct ScopeInfo {
  std::string file;
  std::string prefix;  ///< "rig." for what stands in the part called rig; "" for the diagram itself
  Origin used_at;      ///< the block that uses it; unused for scope 0
};

/// One element of a signal as it is written, "v.2" or "R.2.3", from 1; row 0: the whole signal.
struct ElementIndex {
  Eigen::Index row = 0;
  Eigen::Index column = 0;  ///< 0: of a vector

  bool is_whole() const { return row == 0; }
  bool operator==(const ElementIndex&) const = default;
};

/// What feeds an input: an output of a block or an element of one, or constant numbers.
struct Source {
  int block = -1;  ///< -1: the constant
  int output = -1;
  Eigen::VectorXd constant;
  std::optional<unit::Dimension> dimension;  ///< of the constant, if it was written with a unit
  Origin origin;
  std::shared_ptr<const Binding> text;  ///< of a constant that follows from parameters
  ElementIndex element{};
  Eigen::Index columns = 1;  ///< of a constant that is a matrix, column by column
};

/// An initial value that the file gives to a state.
struct InitialValue {
  int state = -1;
  Eigen::VectorXd value;
  std::optional<unit::Dimension> dimension;
  Origin origin;
  Eigen::Index columns = 1;  ///< of a matrix, column by column
};

/// One block after parts are opened.
struct DiagramBlock {
  DiagramBlock(std::string full_name, const BlockType& type) : name(std::move(full_name)), block(type) {}

  std::string name;  ///< full: "rig.carriage"
  AnyBlock block;    ///< with its parameters set
  Origin origin;
  std::vector<std::vector<Source>> inputs;  ///< for each input of the type; empty where not connected
  std::vector<yaml::Mark> input_marks;
  std::vector<yaml::Mark> parameter_marks;
  std::vector<std::optional<unit::Dimension>>
      parameter_dimensions;  ///< of each parameter, where written with a unit
  std::vector<std::pair<std::size_t, Eigen::Index>>
      matrices;                     ///< numbers for each element that are a matrix: parameter, columns
  std::vector<std::size_t> spread;  ///< parameters whose one number the plan repeats for every element
  std::vector<InitialValue> initial;
  std::vector<std::pair<std::string, unit::Dimension>>
      known_units;  ///< unit variables that the block itself fixes: ("'u", mm)
  std::optional<Every> every;
  Origin every_origin;
  bool every_of_part = false;  ///< is the period that of the part around it?
  int guard = -1;              ///< the block that decides whether this one is active; -1: it always is
  std::string copy_of;  ///< the block of the file, full, of which this is the copy for one field of a bus

  const BlockType& type() const { return block.type(); }
};

/// An output of a block, or one of its states, or an element of these.
struct SignalRef {
  int block = -1;
  int output = -1;
  int state = -1;  ///< where output is -1
  ElementIndex element{};

  bool operator==(const SignalRef&) const = default;
};

/// A port of a part, which is the name of a signal that others make or read.
struct PartPort {
  std::string name;  ///< full: "rig.force"
  SignalRef signal;
};

/// A bus: signals with names. Those of buses inside are dotted, "pose.position". The plan knows none.
struct DiagramBus {
  std::string name;  ///< full: "rig.wrench"
  std::vector<std::pair<std::string, SignalRef>> fields;
};

struct RecordedSignal {
  std::string name;  ///< as the file wrote it, and as figures and claims call it
  SignalRef signal;
  Origin origin;
};

/// Signals that are recorded at one period, or on both sides of every instant.
struct RecordRequest {
  std::optional<double> every;  ///< [s]; every step if absent
  bool instants = false;        ///< at ticks, edges of sources and events: a row before and a row after it
  Origin origin;
  std::vector<RecordedSignal> signals;
};

/// An input of the diagram itself: a block of type ExternalInput, which whoever runs the diagram may write.
struct DiagramInput {
  std::string name;
  int block = -1;
  std::string doc;
};

/// An output of the diagram itself: what whoever runs it hands on, e.g. to an amplifier.
struct DiagramOutput {
  std::string name;
  SignalRef signal;
  std::optional<Eigen::VectorXd> safe;  ///< what to hand on once the diagram no longer runs
  std::optional<unit::Dimension> safe_dimension;
  std::string doc;
  Origin origin;
};

/// A port of a part with a declared unit: what passes must have it.
struct UnitDemand {
  Source source;
  unit::Dimension dimension;
  std::string port;  ///< "rig.force"
  Origin origin;
};

/// A port or a field of a bus with a declared shape: what passes must have it.
struct ShapeDemand {
  Source source;
  Eigen::Index rows = 1, columns = 1;
  std::string port;  ///< "rig.wrench.force"
  Origin origin;
};

/// A parameter of the diagram or of one of its parts, after expressions and settings.
struct DiagramParameter {
  std::string name;  ///< full: "rig.mass"
  std::string text;  ///< as written or set
  Value value;
  std::optional<unit::Dimension> dimension;
  std::string doc;
  bool assumed = false;
  bool set = false;  ///< not the file's own value
};

/// `stop_when`, with what its expression reads, in the order of its variables.
struct StopCondition {
  expression::Expression expression;
  std::vector<SignalRef> variables;  ///< "time" has block -1
  Origin origin;
};

/// What becomes of outputs that depend on themselves at the same instant.
struct AlgebraicLoops {
  bool solve = false;                 ///< else they are refused
  double tolerance = 1e-9;            ///< largest correction that is none, in sizes of its signal
  std::int64_t max_iterations = 500;  ///< passes through a loop at one instant
};

/// What becomes of crossings between two ticks.
struct Events {
  bool locate = false;             ///< else blocks find them at the next tick
  std::int64_t max_per_step = 50;  ///< beyond, the run ends
  std::int64_t rounds = 100;       ///< at one instant; likewise
  static constexpr std::int64_t usual_looks = 4;
  std::int64_t looks = usual_looks;  ///< within a step for what crosses twice; 0: none
  /// More looks than usual are taken in every step, and not only where a number comes near to 0.
  bool looks_always() const { return looks > usual_looks; }
};

/// How far the steps of a solver may err that chooses their length: a state by relative |x| + absolute.
struct ErrorControl {
  double relative = 1e-6;
  double absolute = 1e-9;           ///< in the state's own SI unit
  std::int64_t max_steps = 100000;  ///< between two instants; beyond, the run ends
};

/// What of the thesis a diagram shows.
struct ThesisReference {
  std::optional<int> figure, table;
  std::string section;
  std::string caption;                  ///< of the figure, as the thesis prints it
  std::string says;                     ///< what its text says of the figure, word for word
  std::vector<std::string> departures;  ///< what is done otherwise here, a sentence each
};

/// A checked diagram: names resolved, parts opened, parameters in their blocks.
struct Diagram {
  std::string file, title, caption;
  double step = 0.0;  ///< [s]
  double stop = 0.0;  ///< [s]
  Origin step_origin, stop_origin;
  std::string solver;  ///< empty if the file names none
  Origin solver_origin;
  std::optional<ErrorControl> error_control;  ///< empty for a solver that takes the steps of the file
  double tolerance = 0.1;  ///< largest error of a step of an implicit solver, in sizes of its state
  AlgebraicLoops algebraic_loops;
  Events events;
  ThesisReference thesis;

  std::vector<ScopeInfo> scopes;
  std::vector<DiagramBlock> blocks;
  std::vector<UnitDemand> unit_demands;
  std::vector<ShapeDemand> shape_demands;
  std::vector<DiagramInput> inputs;
  std::vector<DiagramOutput> outputs;
  std::vector<PartPort> part_ports;  ///< but for those that are fed by constants
  std::vector<DiagramBus> buses;     ///< but for fields that are fed by constants
  std::vector<RecordRequest> records;
  std::vector<DiagramParameter> parameters;
  yaml::Node sensitivity;                    ///< as written, read by the sensitivity room; empty where absent
  std::shared_ptr<const Bindings> bindings;  ///< how its values follow from the parameters
  PortUnits output_dimensions;               ///< see infer_units
  PortUnits state_dimensions;                ///< of the states
  std::vector<ElementDimensions> element_dimensions;  ///< where output_dimensions has no unit for all
  std::optional<Sweep> sweep;
  std::optional<StopCondition> stop_when;
  yaml::Node figure, claims, invariants;  ///< as written, read by the figure room; empty where absent
  yaml::Node scene;                       ///< as written, read by the figure room; empty where absent
  yaml::Node fit;                         ///< as written, read by the identify room; empty where absent

  yaml::Place place(const Origin& origin) const {
    return {scopes[static_cast<std::size_t>(origin.scope)].file, origin.mark};
  }
  /// A fault with its place and everybody who used the part in which it lies.
  yaml::Fault fault(const Origin& origin, std::string subject, yaml::Message message) const;
};

}  // namespace stepwire::diagram
