#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/model/block/value.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Switches of a LayerActivator as its numbers.
struct LayerSwitches {
  std::vector<double> ways, events;
};

/// Reads the switches of a LayerActivator from its file and checks them.
class LayerReader {
 public:
  /// Function that throws a message for a piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;

  LayerReader(Index layers, Index regions, Refuse refuse)
      : layers_(layers), regions_(regions), refuse_(std::move(refuse)) {}

  LayerSwitches read(const Value& tree) const;

 private:
  void read_switch(const Value& tree, LayerSwitches& all) const;
  std::vector<double> read_event(const Value& tree) const;
  std::vector<double> read_pass(const Value& tree) const;
  std::vector<double> read_cross(const Value& tree) const;
  std::vector<double> read_point(const Value* tree, const Value& event) const;
  double read_index(const Value* tree, const Value& owner, const std::string& what, Index most) const;
  double read_quantity(const Value* tree, const Value& owner, const std::string& what,
                       const std::string& unit) const;
  void allow(const Value& tree, const std::vector<std::string>& keys) const;

  Index layers_, regions_;
  Refuse refuse_;
};

}  // namespace stepwire
