#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "engine/model/diagram/definitions.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"
#include "engine/model/diagram/uses.hpp"

namespace stepwire::diagram {

/// An input as written in a file; it is resolved once all names are known.
struct PendingInput {
  int block;
  int input;
  const yaml::Node* node;
  const Scope* scope;
};

/// Opens a file and its parts: evaluates parameters, creates blocks with their parameters, and collects
/// names. Inputs stay pending.
class Opener {
 public:
  Opener(Loader& loader, Settings& settings, Report& report)
      : loader_(loader), settings_(settings), report_(report) {}

  void open(Scope& scope, const Overrides& overrides);
  /// Copies blocks with buses at their inputs for every field; called before inputs are resolved.
  void copy_for_buses(Scope& root);
  const std::deque<PendingInput>& pending() const { return pending_; }
  /// Connects blocks to the Guards that they name, once all names are known.
  void join_guards();

 private:
  /// Result of `enable` and `trigger` of a part or block.
  struct Guarding {
    int guard = -1;  ///< the block that they create; -1 without such keys
    int edge = 0, states = 0;
    const yaml::Node* outputs = nullptr;  ///< see GuardOptions
  };
  /// Predicate: True for a key that the part or block itself has.
  using KeyTaken = std::function<bool(const char* key)>;
  void declare_ports(Scope& scope);
  /// Adds the fault of a block or part that cannot be created, and suppresses faults of the wires to it.
  void fail(Scope& scope, const yaml::Entry& entry, const yaml::Mark& mark, yaml::Message message);
  void open_block(Scope& scope, const yaml::Entry& entry);
  void declare_input(Scope& scope, const yaml::Entry& port);
  void declare_output(Scope& scope, const yaml::Entry& port);
  /// Creates a block for each input of the diagram itself whose `default` is a value.
  void make_inputs(Scope& scope);
  void split_inputs(Scope& scope);
  std::optional<unit::Dimension> declared_unit(const Scope& scope, const yaml::Entry& port);
  std::optional<std::pair<Eigen::Index, Eigen::Index>> declared_shape(const Scope& scope,
                                                                      const yaml::Entry& port);
  void open_part(Scope& scope, const yaml::Entry& entry, const yaml::Node& path);
  /// Checks the section `uses` of a file, once for each file.
  void read_uses(const Scope& scope);
  bool read_use(const Scope& scope, const Use& use);
  /// Refuses a part of unusable fetched files, and one outside of the fetched files of its user.
  bool refuse_fetched(Scope& scope, const yaml::Entry& entry, const yaml::Node& path,
                      const std::string& file);
  bool refuse_nesting(Scope& scope, const yaml::Entry& entry, const yaml::Node& path,
                      const std::string& file);
  /// Reads the part's file; adds a fault and returns false if that fails.
  bool read_part(Scope& scope, const yaml::Entry& entry, const yaml::Node& path, Scope& part);
  /// Assigns the keys of the using file to the part's inputs, and returns those for its parameters.
  Overrides feed(const Scope& scope, const yaml::Entry& entry, const yaml::Node& path, Scope& part);
  void make_block(Scope& scope, const yaml::Entry& entry, const BlockType& type);
  void make_bus(Scope& scope, const yaml::Entry& entry);
  void apply_preset(Scope& scope, const yaml::Node& map, DiagramBlock& block);
  void read_key(Scope& scope, const yaml::Entry& key, DiagramBlock& block, int index);
  void read_settings(Scope& scope, DiagramBlock& block, const std::string& full);
  void read_parameter(const Scope& scope, int reader_scope, const yaml::Node& node, DiagramBlock& block,
                      std::size_t parameter);
  void read_initial(const Scope& scope, const yaml::Node& node, DiagramBlock& block, int state);
  /// Reads a setting. A bare number, which is in SI, keeps the dimension of the file's value.
  void set_parameter(const Scope& scope, int reader_scope, const yaml::Node& text, DiagramBlock& block,
                     std::size_t parameter);
  void set_initial(const Scope& scope, const yaml::Node& text, DiagramBlock& block, int state);
  int index_of(const DiagramBlock& block);
  /// Stores the text of a value that depends on parameters.
  void bind(const Target& target, ValueText text, ParameterUses uses);
  void read_period(const Scope& scope, const yaml::Node& node, DiagramBlock& block);
  void require_parameters(const Scope& scope, const yaml::Node& map, const DiagramBlock& block);
  bool is_fed(const Scope& scope, const yaml::Entry& key, const BlockType& type) const;

  bool hidden(const Scope& scope, const std::string& name) const;
  /// Adds a block that files cannot name.
  int add_hidden(const Scope& scope, const std::string& name, const BlockType& type, const yaml::Mark& mark);
  static void make_room(DiagramBlock& block);
  void feed_hidden(int block, int input, int from, const Origin& origin);
  /// `active` is the guard's name after that of its part or block.
  Guarding open_guard(Scope& scope, const yaml::Entry& entry, const KeyTaken& is_own, const char* active);
  void feed_guard(Scope& scope, const std::string& owner, const char* key, const yaml::Node& node, int guard);
  int add_condition(Scope& scope, const std::string& name, const yaml::Node& node);
  yaml::Node source_of_variable(const Scope& scope, const std::string& variable, const yaml::Mark& mark);
  int show_output(Scope& scope, const std::string& owner, const std::string& output, const Guarding& guarding,
                  const yaml::Mark& mark);
  void show_outputs(Scope& scope, const yaml::Entry& entry, const Guarding& guarding, int block);
  void show_outputs(Scope& scope, const yaml::Entry& entry, const Guarding& guarding, Scope& part);
  /// Reads `every` of a part, the default of its blocks.
  void read_period_of_part(const Scope& scope, const yaml::Entry& entry, const KeyTaken& is_own, Scope& part);
  void take_period_of_part(const Scope& scope, DiagramBlock& block);
  void join_with_part(const Scope& scope, const Origin& origin, const std::string& name, Every& every);
  std::optional<Every> read_every(const Scope& scope, const yaml::Node& node, const std::string& subject);
  std::optional<double> read_time(const Scope& scope, const yaml::Node& node, const std::string& subject);

  Loader& loader_;
  Settings& settings_;
  Report& report_;
  std::deque<PendingInput> pending_;
  struct Within {
    int block;
    const yaml::Node* node;
    const Scope* scope;
  };
  std::vector<Within> within_;
  std::deque<yaml::Node> made_;     ///< sources of hidden blocks
  std::deque<yaml::Node> written_;  ///< sources of the fields of buses at inputs
  struct KnownUse {
    Use use;
    Origin origin;
    bool usable;
  };
  std::map<std::string, KnownUse> uses_;  ///< by name
  std::set<const yaml::Document*> with_uses_read_;
  FetchedTrees fetched_;
  std::vector<std::string> open_files_;
  std::vector<std::string> block_words_;  ///< lists of names given to the block under construction
};

}  // namespace stepwire::diagram
