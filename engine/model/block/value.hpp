#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stepwire {

struct ValueEntry;

/// Value of a parameter as a block receives it: SI numbers, text, or for a tree (states of a StateMachine)
/// maps and lists of the original texts, with their locations.
struct Value {
  using List = std::vector<Value>;
  using Map = std::vector<ValueEntry>;
  std::variant<double, bool, std::string, Eigen::VectorXd, Eigen::MatrixXd, List, Map>
      content;   ///< the number 0 by default
  int line = 0;  ///< in the file, from 1; 0 without a file
  int column = 0;

  const std::string* text() const { return std::get_if<std::string>(&content); }
  const List* list() const { return std::get_if<List>(&content); }
  const Map* map() const { return std::get_if<Map>(&content); }
  const Value* find(std::string_view key) const;
};

struct ValueEntry {
  std::string key;
  Value value;
};

inline const Value* Value::find(std::string_view key) const {
  if (!map()) return nullptr;
  for (const ValueEntry& entry : *map())
    if (entry.key == key) return &entry.value;
  return nullptr;
}

}  // namespace stepwire
