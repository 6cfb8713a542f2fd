#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace stepwire::fmi {

/// How a variable's values lie in memory; a Boolean of FMI 2 is an int.
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
  other  ///< text, bytes and clocks, which are no numbers
};

enum class Causality { parameter, calculated, input, output, local, independent, structural };

/// A variable of a unit. Numbers are SI; value_si = offset + factor * value of the unit.
struct Variable {
  std::string name, description;
  std::string port;  ///< the name with '_' in the place of what no name of a port may have
  std::uint32_t reference = 0;
  Type type = Type::float64;
  Causality causality = Causality::local;
  bool discrete = false;  ///< changes at events alone
  bool constant = false;
  bool starts_exact = false;  ///< may its value be set before the start?
  std::string unit = "*";     ///< in SI; "*" where the unit says none
  double factor = 1.0, offset = 0.0;
  std::optional<double> at_least, at_most;  ///< SI
  std::size_t size = 1;
};

/// One of the two interfaces of a unit.
struct Interface {
  std::string identifier;    ///< name of its binary; empty where the unit does not have the interface
  bool keeps_state = false;  ///< can its state be saved as bytes, and be put back?
  bool only_once = false;    ///< may a process have but one instance?
  bool needs_tool = false;
};

/// The annotation of our own units of which no output jumps by the time alone.
constexpr char own_annotation[] = "stepwire", smooth_element[] = "smooth";

/// What modelDescription.xml says of a unit.
struct Description {
  int version = 3;  ///< of FMI
  std::string name, token;
  Interface co_simulation, model_exchange;
  std::vector<Variable> variables;
  std::vector<std::uint32_t> states, derivatives;  ///< references of those that are continuous
  std::size_t state_count = 0;                     ///< in numbers
  std::size_t indicator_count = 0;
  bool smooth = false;  ///< with our own annotation: outputs jump only where inputs do
  std::unordered_map<std::uint32_t, std::size_t> places;  ///< of the first variable with each reference
  /// References of variables that outputs depend on; std::nullopt if an output has no list of them.
  std::optional<std::unordered_set<std::uint32_t>> feeding;

  const Variable* find(std::uint32_t reference) const;
  /// May an output follow this input at the same instant?
  bool feeds_through(const Variable& input) const;
};

/// Reads modelDescription.xml. Throws UnitError for what is none, and for versions other than 2.0 and 3.0.
Description read_description(const std::string& xml);

}  // namespace stepwire::fmi
