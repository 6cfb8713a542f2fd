#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

class Report;

/// Is this the name of a signal, not a number, `$name`, `= expression`, list or map?
bool names_signal(const yaml::Node& node);

/// Finds what a reference such as "lag", "lag.y" or "rig.x" means in a file, through the ports of parts.
/// In resolve.cpp what is one signal, in resolve_bus.cpp what buses are.
class Resolver {
 public:
  /// The fields of blocks that are not yet copied for each.
  using Stores = std::function<std::vector<std::string>(int block, int hops)>;

  explicit Resolver(Report& report, Stores stores = {}) : report_(report), stores_(std::move(stores)) {}

  /// What one element of an input is fed by: a reference, a number, `$name` or `= expression`.
  std::optional<Source> source(const yaml::Node& node, const Scope& scope, const std::string& subject) const;
  /// The same for the name of a signal.
  std::optional<Source> source(const std::string& name, const Scope& scope, const Origin& origin,
                               const std::string& subject) const;
  /// A signal by name; states and what lies inside of parts may be named too. `origin` is for messages.
  std::optional<SignalRef> signal(const std::string& text, const Scope& scope, const Origin& origin,
                                  const std::string& subject) const;
  /// The fields of what a wire names, "force", "pose.position"; none where it is no bus.
  std::vector<std::string> fields(const yaml::Node& node, const Scope& scope, int hops = 0) const;
  /// One field of what a wire names.
  std::optional<Source> field(const yaml::Node& node, const Scope& scope, const std::string& name,
                              const std::string& subject) const;

 private:
  // More ports than this cannot lie one behind the other: parts are nested at most 32 deep.
  static constexpr int max_hops = 256;

  struct Query {
    Origin origin;  ///< what to blame where a name means nothing
    Origin wire;    ///< what to blame where the ends do not fit
    std::string subject;
    bool look_inside;  ///< may states and the inside of parts be named?
    int hops = 0;
  };
  std::optional<Source> element(const yaml::Node& node, const Scope& scope, Query query) const;
  std::optional<Source> reference(const std::string& text, const Scope& scope, Query query) const;
  /// An element of what was found.
  std::optional<Source> picked(std::optional<Source> source, const ElementIndex& element,
                               const std::string& text, const Query& query) const;
  /// One field of what a wire names.
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
  /// The output of a block or part that is meant; empty where none is.
  std::string output_of(const std::string& rest, const Scope::Named& named) const;
  /// "out.force" for "force", where the part has an output only; else the same.
  static std::string field_of_output(const std::string& rest, const Scope::Named& named);
  /// The only output of a part, where it is a bus with this field; else null.
  const yaml::Node* only_bus(const Scope& part, const std::string& field, int hops) const;
  /// The only output of a block.
  static std::optional<Source> output_source(int block, const Query& query);
  std::nullopt_t refuse(const Query& query, yaml::Message message) const;

  Report& report_;
  Stores stores_;
};

}  // namespace stepwire::diagram
