#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

class Report;

/// True for the name of a signal; false for a number, `$name`, `= expression`, list or map.
bool names_signal(const yaml::Node& node);

/// Resolves references such as "lag", "lag.y" or "rig.x" in a file, through the ports of parts. Single
/// signals are in resolve.cpp, buses in resolve_bus.cpp.
class Resolver {
 public:
  /// Function that returns the fields of blocks that are not yet copied for each field.
  using Stores = std::function<std::vector<std::string>(int block, int hops)>;

  explicit Resolver(Report& report, Stores stores = {}) : report_(report), stores_(std::move(stores)) {}

  /// Returns the source of one element of an input: a reference, a number, `$name` or `= expression`.
  std::optional<Source> source(const yaml::Node& node, const Scope& scope, const std::string& subject) const;
  /// Returns the source for the name of a signal.
  std::optional<Source> source(const std::string& name, const Scope& scope, const Origin& origin,
                               const std::string& subject) const;
  /// Returns a signal by name; states and signals inside of parts are allowed as well. `origin` is for
  /// messages.
  std::optional<SignalRef> signal(const std::string& text, const Scope& scope, const Origin& origin,
                                  const std::string& subject) const;
  /// Returns the fields of the bus that a wire names, "force", "pose.position"; an empty list for other
  /// names.
  std::vector<std::string> fields(const yaml::Node& node, const Scope& scope, int hops = 0) const;
  /// Returns one field of the bus that a wire names.
  std::optional<Source> field(const yaml::Node& node, const Scope& scope, const std::string& name,
                              const std::string& subject) const;

 private:
  // Bound on the ports that one reference passes through: parts are nested at most 32 deep.
  static constexpr int max_hops = 256;

  struct Query {
    Origin origin;  ///< location of the fault for an unknown name
    Origin wire;    ///< location of the fault for incompatible ends
    std::string subject;
    bool look_inside;  ///< allows states and signals inside of parts
    int hops = 0;
  };
  std::optional<Source> element(const yaml::Node& node, const Scope& scope, Query query) const;
  std::optional<Source> reference(const std::string& text, const Scope& scope, Query query) const;
  /// Returns an element of a resolved source.
  std::optional<Source> picked(std::optional<Source> source, const ElementIndex& element,
                               const std::string& text, const Query& query) const;
  /// Returns one field of the bus that a wire names.
  std::optional<Source> field(const yaml::Node& node, const Scope& scope, const std::string& name,
                              Query query) const;
  std::optional<Source> of_bus(const BusFields& bus, const Scope& scope, const std::string& name,
                               Query query) const;
  std::optional<Source> field_of_port(const Scope& scope, const std::string& port, const std::string& name,
                                      Query query) const;
  std::vector<std::string> fields_of_bus(const BusFields& bus, const Scope& scope, int hops) const;
  std::vector<std::string> fields_of_name(const std::string& text, const Scope& scope, int hops) const;
  std::vector<std::string> fields_of_part(const std::string& rest, const Scope& part, int hops) const;
  std::optional<Source> port(const Scope& scope, const std::string& name, Query query) const;
  std::optional<Source> of_block(const std::string& rest, int block, const Query& query) const;
  std::optional<Source> of_part(const std::string& rest, const Scope& part, Query query) const;
  /// Returns the output of a block or part that a reference denotes; empty if there is none.
  std::string output_of(const std::string& rest, const Scope::Named& named) const;
  /// Returns "out.force" for "force" of a part with a single output; else the name unchanged.
  static std::string field_of_output(const std::string& rest, const Scope::Named& named);
  /// Returns the only output of a part, if it is a bus with this field; nullptr otherwise.
  const yaml::Node* only_bus(const Scope& part, const std::string& field, int hops) const;
  /// Returns the only output of a block.
  static std::optional<Source> output_source(int block, const Query& query);
  std::nullopt_t refuse(const Query& query, yaml::Message message) const;

  Report& report_;
  Stores stores_;
};

}  // namespace stepwire::diagram
