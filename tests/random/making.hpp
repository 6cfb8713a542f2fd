#pragma once

#include <map>
#include <set>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/unit_expression.hpp"
#include "tests/random/bench.hpp"

namespace stepwire::random {

/// Units of the unit variables of one block.
class UnitVariables {
 public:
  /// The unit of an expression; nullopt for "*" and while a variable is unknown.
  std::optional<unit::Dimension> value(const std::string& text) const;
  /// Makes unknown variables of an expression such that it is this unit, as far as there are any.
  void take(const std::string& text, const unit::Dimension& unit);

 private:
  std::map<std::string, unit::Dimension> known_;
};

/// A block that is being added to a bench: its sizes, units, keys.
class Making {
 public:
  Making(Bench& bench, const BlockType& type) : bench(bench), type(type), entry{bench.next_name(), {}} {}

  Bench& bench;
  const BlockType& type;
  Entry entry;
  std::map<std::string, Shape> shapes;  ///< by letter; rows or columns of a matrix are those of a vector
  std::map<std::string, std::size_t> counts;  ///< of lists of inputs
  std::set<std::string> fed;                  ///< optional inputs that have a source
  bool inputs_are_chosen = false;             ///< these alone
  bool moving_delay = false;                  ///< a TransportDelay whose delay is a signal
  UnitVariables units;
  double period = 0.0;  ///< between its updates [s]

  /// Adds the block, its sources, and its outputs as wires.
  void make();

  Dice& dice() { return bench.dice; }
  Index size(const std::string& letter);
  /// The shape of a port or a parameter; letters that are unknown become some size.
  Shape shape_of(const std::string& text);
  bool is_known(const std::string& text) const;
  void set(const std::string& key, const std::string& value) { entry.keys.push_back({key, value}); }
  bool has(const std::string& key) const { return entry.find(key) != nullptr; }
  /// The unit of a parameter, whose unknown variables become some unit.
  unit::Dimension unit_of(const std::string& text);

 private:
  void choose_period();
  void choose_inputs();
  void connect_all();
  std::string connect(const InputSpec& input);
  std::string connect_list(const InputSpec& input);
  Wire element_of_list(const InputSpec& input, std::size_t index);
  Wire wire_for(const InputSpec& input);
  std::optional<std::string> promise_for(const InputSpec& input);
  void give_parameters();
  void give_initial_values();
  void guard();
  void guard_at_ticks();
  void add_outputs();
};

}  // namespace stepwire::random
