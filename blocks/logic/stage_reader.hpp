#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blocks/logic/stages.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Reads the states of a StateMachine from its file and checks them.
class StageReader {
 public:
  /// `refuse` throws: what is wrong, and with which piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  StageReader(const Value& tree, std::size_t inputs, Refuse refuse);

  std::vector<Stage> read() const;
  std::size_t index_of(const std::string& name) const;  ///< or none
  std::string names() const;
  void refuse_unreachable(const std::vector<Stage>& stages, std::size_t first) const;

 private:
  Stage read_stage(const std::string& name, const Value& tree) const;
  std::vector<double> read_output(const std::string& name, const Value& tree) const;
  double read_number(const std::string& name, const Value& tree) const;
  Transition read_transition(const std::string& name, const ValueEntry& entry) const;
  Guard read_guard(const std::string& subject, const Value& tree) const;
  std::size_t variable(std::string_view name) const;
  void level_outputs(std::vector<Stage>& stages) const;

  const Value& tree_;
  std::size_t inputs_;
  Refuse refuse_;
};

}  // namespace stepwire
