#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/app/simulink/import_result.hpp"
#include "engine/app/simulink/model.hpp"
#include "engine/app/simulink/value.hpp"
#include "engine/app/simulink/workspace.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::simulink {

// A model whose plain subsystems are dissolved: each becomes a prefix in the names of its blocks. A subsystem
// that runs on condition becomes a unit: a part in a file of its own.

struct Unit;

/// A system in its place in the model.
struct Instance {
  const System* system = nullptr;
  const Block* owner = nullptr;  ///< the subsystem; nullptr for the model
  Instance* parent = nullptr;
  Unit* unit = nullptr;
  std::string prefix;  ///< of names in the unit: "Plant."
  std::string path;    ///< for messages: "Plant/"
  std::unordered_map<std::string, const Block*> by_sid;
  std::unordered_map<std::string, LineEnd> sources;         ///< of the port "SID#in:1"
  std::unordered_map<std::string, int> outputs;             ///< greatest port with a line, by SID
  std::unordered_map<std::string, std::string> line_names;  ///< of the signal that leaves "SID#out:1"
  std::unordered_map<const Block*, std::unique_ptr<Instance>> children;
  std::map<int, const Block*> outports;                           ///< by their numbers
  std::unordered_map<const Block*, std::size_t> flat;             ///< indices of blocks that remain
  std::optional<std::map<std::string, Value, std::less<>>> mask;  ///< values of the owner's mask
};

/// A block that remains, with its translation.
struct FlatBlock {
  const Block* block = nullptr;
  Instance* in = nullptr;
  std::string name;                                      ///< in its unit
  std::string path;                                      ///< for messages
  std::vector<std::pair<std::string, yaml::Node>> made;  ///< blocks of the diagram
  std::vector<std::string> comments;                     ///< lines above it
  std::map<int, std::string> outputs;  ///< texts of its outputs; the name where there is none
  std::string has_run{};               ///< block that is 1 from the first run of a part on; empty: none
};

/// Output of a subsystem that runs on condition, while that is off.
struct Rest {
  bool is_reset = false;  ///< It has the initial value at each end of an activity, and holds otherwise.
  std::optional<Value> initial;  ///< Value before the first run; nullopt: that of the blocks inside.
};

/// A file of the diagram: the model, or a subsystem that runs on condition.
struct Unit {
  Unit* parent = nullptr;
  std::string name;  ///< of the block in the parent; empty for the model.
  std::string title;
  std::string file;  ///< path of the part, as its user writes it.
  Instance* instance = nullptr;
  std::vector<std::size_t> blocks;
  std::set<std::string> names;  ///< that are used.
  std::map<std::string, int> copies;
  std::set<std::string> variables;  ///< of the workspace.
  std::map<std::string, std::string>
      tags;                         ///< inputs for tags of Goto outside, with the source in the parent.
  std::vector<std::string> inputs;  ///< by the number of the port.
  std::map<int, std::pair<std::string, std::string>> outputs;  ///< names and sources, by the port.
  std::map<int, Rest> rests;    ///< outputs with a value of their own while it is off, by the port.
  bool resets_outputs = false;  ///< all outputs have their `safe` values while it is off.

  /// Returns a name that is still free, and takes it.
  std::string take_name(const std::string& wanted);
};

/// A dissolved model, and what its translation needs of it.
class FlatModel {
 public:
  FlatModel(const Model& model, std::vector<Note>& notes);

  std::vector<FlatBlock>& blocks() { return blocks_; }
  const std::vector<FlatBlock>& blocks() const { return blocks_; }
  std::vector<std::unique_ptr<Unit>>& units() { return units_; }
  Instance& root() { return *root_; }
  const Model& model() const { return model_; }
  Workspace& workspace() { return workspace_; }

  /// Returns the text of the source of a port: a token of a block's output, the name of an input, or "0" for
  /// an unconnected port.
  std::string source(Instance& in, const Block& block, const std::string& port);
  bool is_connected(const Instance& in, const Block& block, const std::string& port) const;
  /// Returns the number of inputs of a block, by the file and its lines.
  int inputs_of(const Instance& in, const Block& block) const;
  /// Returns the number of outputs of a block; written_outputs_of() leaves out its lines.
  int outputs_of(const Instance& in, const Block& block) const;
  int written_outputs_of(const Block& block) const;
  /// Returns the name of the signal at an input; empty if it has none.
  std::string signal_name(const Instance& in, const Block& block, const std::string& port) const;
  /// Evaluates a MATLAB text in a system. Throws ValueError.
  Value evaluate(Instance& in, const std::string& text);
  /// Returns a text with the tokens replaced by names.
  std::string resolved(const std::string& text, int depth = 0) const;
  /// Returns the index of the block and the port of a text that is one token.
  static std::optional<std::pair<std::size_t, int>> token_of(const std::string& text);

 private:
  using GotoBlock = std::pair<Instance*, const Block*>;

  void build(Instance& instance);
  /// Returns the system whose From blocks read a tag, with inner systems unless the tag is local.
  Instance* scope_of(const GotoBlock& block) const;
  void note_equal_tags();
  void name_input(Instance& instance, const Block& block);
  static void add_lines(Instance& instance);
  void add_block(Instance& instance, const Block& block);
  void pass_through(Instance& instance, const Block& block);
  void add_flat(Instance& instance, const Block& block);
  void add_child(Instance& instance, const Block& block);
  void open_unit(Instance& child);
  std::string follow(Instance& in, const LineEnd& end, int depth);
  /// Reports a fault of a wire, and returns "0".
  std::string no_source(const std::string& path, const std::string& what);
  std::string follow_from(Instance& in, const Block& block, int depth);
  std::string follow_inport(Instance& in, const Block& block, int depth);
  std::string through_units(Unit& unit, Instance& goto_in, const Block& goto_block, int depth);
  std::string follow_port(Instance& in, const Block& block, const std::string& port, int depth);
  Value variable(Instance& in, const std::string& name, bool is_function);
  void read_mask(Instance& in);

  const Model& model_;
  std::vector<Note>& notes_;
  std::vector<std::string> script_notes_;
  Workspace workspace_;
  std::vector<FlatBlock> blocks_;
  std::vector<std::unique_ptr<Unit>> units_;
  std::unique_ptr<Instance> root_;
  std::multimap<std::string, GotoBlock> gotos_;
  std::set<const Block*> wires_;  ///< that are commented through
  Unit* evaluating_ = nullptr;
};

/// Returns the block of a type in a system; nullptr if there is none.
const Block* block_of_type(const System& system, std::string_view type);
/// True for a subsystem with a port that lets it run on condition.
bool is_conditional(const System& system);
/// Returns the reason for which a subsystem cannot be dissolved; empty if it can.
std::string obstacle_of(const Model& model, const Block& subsystem);
/// Returns the parameter of a block in the file, of its type's defaults in the file, or the given default.
std::string text_of(const Model& model, const Block& block, const std::string& name,
                    const std::string& otherwise);
/// Returns the number of a port block, from 1.
int port_number(const Model& model, const Block& block);

}  // namespace stepwire::simulink
