#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace stepwire::plan {

/// Sizes that are known or found to be equal to others (union-find).
class Sizes {
 public:
  int add() {
    parents_.push_back(static_cast<int>(parents_.size()));
    values_.emplace_back();
    return parents_.back();
  }
  int count() const { return static_cast<int>(parents_.size()); }

  std::optional<Eigen::Index> value(int size) { return values_[static_cast<std::size_t>(root(size))]; }
  /// False if it is known to be another.
  bool set(int size, Eigen::Index value);
  /// False if both are known and differ.
  bool join(int a, int b);
  /// One of all sizes that are equal to this one, the same for each of them.
  int root(int size);

 private:
  std::vector<int> parents_;
  std::vector<std::optional<Eigen::Index>> values_;
};

inline int Sizes::root(int size) {
  while (parents_[static_cast<std::size_t>(size)] != size) {
    int& parent = parents_[static_cast<std::size_t>(size)];
    parent = parents_[static_cast<std::size_t>(parent)];
    size = parent;
  }
  return size;
}

inline bool Sizes::set(int size, Eigen::Index value) {
  auto& known = values_[static_cast<std::size_t>(root(size))];
  if (known) return *known == value;
  known = value;
  return true;
}

inline bool Sizes::join(int a, int b) {
  const int first = root(a), second = root(b);
  const auto value_a = values_[static_cast<std::size_t>(first)],
             value_b = values_[static_cast<std::size_t>(second)];
  if (value_a && value_b && *value_a != *value_b) return false;
  parents_[static_cast<std::size_t>(first)] = second;
  if (value_a) values_[static_cast<std::size_t>(second)] = value_a;
  return true;
}

}  // namespace stepwire::plan
