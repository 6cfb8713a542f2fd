#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace stepwire::fmi {

/// Memory layout of a variable's values; a Boolean of FMI 2 is an int.
enum class Type {
  float64,
  float32,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  boolean,
  wide_boolean,
  other  ///< text, binary data and clocks
};

enum class Causality { parameter, calculated, input, output, local, independent, structural };

/// A variable of a unit. Numbers are SI: value_si = offset + factor * value of the unit.
struct Variable {
  std::string name, description;
  std::string port;  ///< the name with '_' for characters that a port name cannot have
  std::uint32_t reference = 0;
  Type type = Type::float64;
  Causality causality = Causality::local;
  bool discrete = false;  ///< changes only at events
  bool constant = false;
  bool starts_exact = false;  ///< true where its value may be set before the start
  std::string unit = "*";     ///< in SI; "*" without a declared unit
  double factor = 1.0, offset = 0.0;
  std::optional<double> at_least, at_most;  ///< SI
  std::size_t size = 1;
};

/// One of the two interfaces of a unit.
struct Interface {
  std::string identifier;    ///< name of its binary; empty if the unit lacks the interface
  bool keeps_state = false;  ///< true where its state can be serialised and restored
  bool only_once = false;    ///< true where a process may have only one instance
  bool needs_tool = false;
  double internal_step = 0.0;  ///< its own steps [s]; 0: unknown
};

/// Annotation in exported units of ours: no output jumps by time alone.
constexpr char own_annotation[] = "stepwire", smooth_element[] = "smooth";

/// Content of modelDescription.xml.
struct Description {
  int version = 3;  ///< version of FMI
  std::string name, token;
  Interface co_simulation, model_exchange;
  std::vector<Variable> variables;
  std::vector<std::uint32_t> states, derivatives;  ///< references of the continuous ones
  std::size_t state_count = 0;                     ///< number of doubles
  std::size_t indicator_count = 0;
  bool smooth = false;  ///< has our annotation: outputs jump only where inputs do
  std::unordered_map<std::uint32_t, std::size_t> places;  ///< index of the first variable with each reference
  /// References of the variables that outputs depend on; std::nullopt if an output lacks a list of
  /// dependencies.
  std::optional<std::unordered_set<std::uint32_t>> feeding;

  const Variable* find(std::uint32_t reference) const;
  /// True where an output may depend on this input at the same instant.
  bool feeds_through(const Variable& input) const;
};

/// Parses modelDescription.xml. Throws UnitError for another format and for versions other than 2.0 and 3.0.
Description read_description(const std::string& xml);

}  // namespace stepwire::fmi
