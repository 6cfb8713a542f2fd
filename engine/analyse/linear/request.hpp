#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// A name as written by the user, and its place.
struct WrittenName {
  std::string name;
  yaml::Place place{};
  std::string subject{};  ///< Option or key of the name: "--from", "linear.loop.from".
};

/// Options of a linearisation.
struct Request {
  std::vector<WrittenName> from;  ///< Signals to which an input is added.
  std::vector<WrittenName> to;    ///< Signals that are outputs.
  std::vector<WrittenName> open;  ///< Wires that are cut and hold their value.
  double time = 0.0;              ///< Time of the operating point [s].
  std::optional<double> size;     ///< Size of the differences (see DifferenceSizes::only).
  yaml::Place at{};               ///< Place of the time in the file.
  bool whole = false;  ///< True: use all states of the diagram, not only those between inputs and outputs.
};

/// A signal, or one element of it.
struct Signal {
  std::string name;  ///< Name as written.
  diagram::SignalRef signal;
  std::optional<Eigen::Index> element{};  ///< Index from 0; std::nullopt: all elements.
};

/// Returns the refusal of a time [s] that is no multiple of `ticks` steps, with the instants before and after
/// it; empty for a multiple.
std::string between_ticks(double time, const diagram::Diagram& diagram, std::int64_t ticks = 1);

/// Finds an output or a state by the names that `record` accepts, or an input of the diagram. A suffix ".2"
/// selects an element. Faults suggest the nearest name.
std::optional<Signal> find_signal(const diagram::Diagram& diagram, const WrittenName& written,
                                  yaml::Faults& faults);

/// Finds a signal that blocks can read: an output, or a state that is an output.
std::optional<Signal> find_wire(const diagram::Diagram& diagram, const WrittenName& written,
                                yaml::Faults& faults);

/// A named analysis; figures and claims read its results by this name.
struct NamedAnalysis {
  std::string name;
  Request request;
  std::optional<double> feedback{};            ///< Replaces the feedback of the request.
  std::optional<unit::Dimension> dimension{};  ///< Dimension of output over input.
  bool is_sampled = false;  ///< True if a path may have a sampled block, so that poles may be those of z.
};

/// Returns the schema of the section `linear`.
const yaml::Key& linear_form();

/// Reads the value under the key `linear`: {NAME: {from: .., to: ..}}. The signals must exist and have one
/// element each. Adds all faults to `faults`.
std::vector<NamedAnalysis> read_linear(const yaml::Node& node, const query::SymbolTable& names,
                                       const plan::Plan& plan, yaml::Faults& faults);

}  // namespace stepwire::linear
