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
#include "engine/model/diagram/element_units.hpp"
#include "engine/model/diagram/every.hpp"
#include "engine/model/diagram/sweep.hpp"

namespace stepwire::diagram {

struct Binding;
struct Bindings;

/// Units of ports, [block][port], if known.
using PortUnits = std::vector<std::vector<std::optional<unit::Dimension>>>;

/// An output whose elements have different units.
struct ElementDimensions {
  int block = -1, output = -1;
  std::vector<std::optional<unit::Dimension>> each;
};

/// One use of a file in a diagram: the diagram itself (scope 0), or a part in it.
struct ScopeInfo {
  std::string file;
  std::string prefix;  ///< "rig." inside of the part rig; "" for the diagram itself
  Origin used_at;      ///< the block that uses it; unused for scope 0
};

/// One element of a signal, "v.2" or "R.2.3", counted from 1; row 0 is the whole signal.
struct ElementIndex {
  Eigen::Index row = 0;
  Eigen::Index column = 0;  ///< 0 for a vector

  bool is_whole() const { return row == 0; }
  bool operator==(const ElementIndex&) const = default;
};

/// Source of an input: an output of a block or an element of it, or constant numbers.
struct Source {
  int block = -1;  ///< -1 for a constant
  int output = -1;
  Eigen::VectorXd constant;
  std::optional<unit::Dimension> dimension;  ///< of a constant written with a unit
  Origin origin;
  std::shared_ptr<const Binding> text;  ///< of a constant that depends on parameters
  ElementIndex element{};
  Eigen::Index columns = 1;  ///< of a constant matrix in column-major order
  EachUnit each{};           ///< units of a constant's elements in several; `dimension` is then nullopt
};

/// Initial value of a state, given by the file.
struct InitialValue {
  int state = -1;
  Eigen::VectorXd value;
  std::optional<unit::Dimension> dimension;
  Origin origin;
  Eigen::Index columns = 1;  ///< of a matrix in column-major order
  EachUnit each{};           ///< units of elements in several; `dimension` is then nullopt
};

/// A block after all parts are opened.
struct DiagramBlock {
  DiagramBlock(std::string full_name, const BlockType& type) : name(std::move(full_name)), block(type) {}

  std::string name;  ///< full name: "rig.carriage"
  AnyBlock block;    ///< with its parameters set
  Origin origin;
  std::vector<std::vector<Source>> inputs;  ///< for each input of the type; empty if not connected
  std::vector<yaml::Mark> input_marks;
  std::vector<yaml::Mark> parameter_marks;
  std::vector<std::optional<unit::Dimension>>
      parameter_dimensions;  ///< of each parameter written with a unit
  std::vector<std::pair<std::size_t, EachUnit>>
      parameter_elements;  ///< parameters with elements in several units; their dimension is std::nullopt
  std::vector<std::pair<std::size_t, Eigen::Index>>
      matrices;                     ///< per-element parameters given as matrices: parameter, columns
  std::vector<std::size_t> spread;  ///< parameters with one number that the plan repeats for every element
  std::vector<InitialValue> initial;
  std::vector<std::pair<std::string, unit::Dimension>>
      known_units;  ///< Unit variables fixed by the block itself: ("'u", mm).
  std::optional<Every> every;
  Origin every_origin;
  bool every_of_part = false;  ///< True for the period of the enclosing part.
  int guard = -1;              ///< Block that activates this one; -1: always active.
  std::string copy_of;         ///< Full name of the block that this one copies for one field of a bus.

  const BlockType& type() const { return block.type(); }
  /// Returns the units of a parameter with elements in several units; nullptr for another parameter.
  const EachUnit* elements_of(std::size_t parameter) const {
    for (const auto& [index, each] : parameter_elements)
      if (index == parameter) return &each;
    return nullptr;
  }
};

/// Reference to an output of a block, one of its states, or an element of these.
struct SignalRef {
  int block = -1;
  int output = -1;
  int state = -1;  ///< if output is -1
  ElementIndex element{};

  bool operator==(const SignalRef&) const = default;
};

/// A port of a part: another name of a signal.
struct PartPort {
  std::string name;  ///< full name: "rig.force"
  SignalRef signal;
};

/// A bus: named signals. Fields of nested buses have dotted names, "pose.position". Buses do not exist in the
/// plan.
struct DiagramBus {
  std::string name;  ///< full name: "rig.wrench"
  std::vector<std::pair<std::string, SignalRef>> fields;
};

struct RecordedSignal {
  std::string name;  ///< as in the file, in figures and in claims
  SignalRef signal;
  Origin origin;
};

/// Signals recorded at one period, or on both sides of every instant.
struct RecordRequest {
  std::optional<double> every;  ///< [s]; std::nullopt: every step
  bool instants = false;        ///< a row before and after each tick, edge of a source and event
  Origin origin;
  std::vector<RecordedSignal> signals;
};

/// An input of the diagram itself: a block of type ExternalInput that the caller of the run may write.
struct DiagramInput {
  std::string name;
  int block = -1;
  std::string doc;
};

/// An output of the diagram itself: a signal that the caller of the run passes on, for example to an
/// amplifier.
struct DiagramOutput {
  std::string name;
  SignalRef signal;
  std::optional<Eigen::VectorXd> safe;  ///< value to pass on after the end of the run
  std::optional<unit::Dimension> safe_dimension;
  std::string doc;
  Origin origin;
  EachUnit safe_each{};  ///< units of safe elements in several; `safe_dimension` is then nullopt
};

/// Declared unit of a part's port, which its source must have.
struct UnitDemand {
  Source source;
  unit::Dimension dimension;
  std::string port;  ///< "rig.force"
  Origin origin;
};

/// Declared shape of a port or a field of a bus, which its source must have.
struct ShapeDemand {
  Source source;
  Eigen::Index rows = 1, columns = 1;
  std::string port;  ///< "rig.wrench.force"
  Origin origin;
};

/// A parameter of the diagram or one of its parts, after evaluation of expressions and settings.
struct DiagramParameter {
  std::string name;  ///< full name: "rig.mass"
  std::string text;  ///< as written in the file or the setting
  Value value;
  std::optional<unit::Dimension> dimension;
  std::string doc;
  bool assumed = false;
  bool set = false;  ///< it replaces the file's own value
  EachUnit each{};   ///< units of elements in several; `dimension` is then nullopt
};

/// Expression of `stop_when`, and its signals in the order of its variables.
struct StopCondition {
  expression::Expression expression;
  std::vector<SignalRef> variables;  ///< "time" has block -1
  Origin origin;
};

/// Treatment of algebraic loops.
struct AlgebraicLoops {
  bool solve = false;                 ///< otherwise they are refused
  double tolerance = 1e-9;            ///< largest correction at convergence, relative to the signal
  std::int64_t max_iterations = 500;  ///< most iterations of a loop at one instant
};

/// Treatment of crossings between two ticks.
struct Events {
  bool locate = false;             ///< otherwise blocks detect them at the next tick
  std::int64_t max_per_step = 50;  ///< more end the run
  std::int64_t rounds = 100;       ///< most event iterations at one instant; more end the run
  static constexpr std::int64_t usual_looks = 4;
  std::int64_t looks = usual_looks;  ///< checks within a step for double crossings; 0: none
  /// True for more checks than usual: they are then made in every step, and not only where a crossing
  /// function is close to 0.
  bool looks_always() const { return looks > usual_looks; }
};

/// Error tolerance of a variable-step solver: for a state x it is relative |x| + absolute.
struct ErrorControl {
  double relative = 1e-6;
  double absolute = 1e-9;           ///< in the SI unit of the state
  std::int64_t max_steps = 100000;  ///< between two instants; more end the run
};

/// Figure or table of a publication that a diagram reproduces.
struct Reproduction {
  std::optional<int> figure, table;
  std::string section;
  std::string caption;                  ///< of the figure, as printed
  std::string says;                     ///< statements of its text about the figure, word for word
  std::vector<std::string> departures;  ///< differences of this diagram, a sentence each
};

/// A checked diagram: names resolved, parts opened, parameters set in their blocks.
struct Diagram {
  std::string file, title, caption;
  double step = 0.0;  ///< [s]
  double stop = 0.0;  ///< [s]
  Origin step_origin, stop_origin;
  std::string solver;  ///< empty if the file names none
  Origin solver_origin;
  std::optional<ErrorControl> error_control;  ///< std::nullopt for a solver with the steps of the file
  double tolerance = 0.1;  ///< largest error of a step of an implicit solver, relative to the state
  AlgebraicLoops algebraic_loops;
  Events events;
  bool uses_libm = false;  ///< Functions such as sin are those of the C library, otherwise those of SLEEF.
  Reproduction reproduces;

  std::vector<ScopeInfo> scopes;
  std::vector<DiagramBlock> blocks;
  std::vector<UnitDemand> unit_demands;
  std::vector<ShapeDemand> shape_demands;
  std::vector<DiagramInput> inputs;
  std::vector<DiagramOutput> outputs;
  std::vector<PartPort> part_ports;  ///< except those with constant sources
  std::vector<DiagramBus> buses;     ///< except fields with constant sources
  std::vector<RecordRequest> records;
  std::vector<DiagramParameter> parameters;
  yaml::Node sensitivity;                    ///< as written, read by analyse/sensitivity; empty if absent
  std::shared_ptr<const Bindings> bindings;  ///< dependence of its values on the parameters
  PortUnits output_dimensions;               ///< see infer_units
  PortUnits state_dimensions;                ///< of the states
  std::vector<ElementDimensions> element_dimensions;  ///< if output_dimensions has no common unit
  /// Zeros of outputs without a known unit if they are in K: 2 for twice a temperature. See Dimension::zeros.
  std::vector<std::vector<std::optional<double>>> zeros_if_kelvin;
  std::optional<Sweep> sweep;
  std::optional<StopCondition> stop_when;
  yaml::Node figure, claims, invariants;  ///< as written, read by view/plot and analyse/claim
  yaml::Node scene;                       ///< as written, read by view/scene; empty if absent
  yaml::Node fit;                         ///< as written, read by analyse/estimation; empty if absent

  yaml::Place place(const Origin& origin) const {
    return {scopes[static_cast<std::size_t>(origin.scope)].file, origin.mark};
  }
  /// Returns a fault with its location and the chain of users of the part that contains it.
  yaml::Fault fault(const Origin& origin, std::string subject, yaml::Message message) const;
};

}  // namespace stepwire::diagram
