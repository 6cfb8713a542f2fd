#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::linear {

/// A name as somebody has written it, and where.
struct WrittenName {
  std::string name;
  yaml::Place place{};
  std::string subject{};  ///< "--from", "linear.loop.from"
};

/// What is to be linearized, where and how.
struct Request {
  std::vector<WrittenName> from;  ///< to these signals something is added
  std::vector<WrittenName> to;    ///< these are looked at
  std::vector<WrittenName> open;  ///< here wires are cut, and hold what they carry
  double time = 0.0;              ///< when [s]
  std::optional<double> size;     ///< of differences, a share of the number or of 1; none: see slopes_of
  bool whole = false;             ///< all states of the diagram, whatever lies between inputs and outputs
};

/// A signal, or one element of it.
struct Signal {
  std::string name;  ///< as it is written
  diagram::SignalRef signal;
  std::optional<Eigen::Index> element{};  ///< from 0; none: all
};

/// Finds an output or a state by the names that `record` takes, or an input of the diagram; ".2" behind it is
/// an element. Faults have the nearest name.
std::optional<Signal> find_signal(const diagram::Diagram& diagram, const WrittenName& written,
                                  yaml::Faults& faults);

/// The same of a signal that blocks read: an output, or a state that is one.
std::optional<Signal> find_wire(const diagram::Diagram& diagram, const WrittenName& written,
                                yaml::Faults& faults);

}  // namespace stepwire::linear
