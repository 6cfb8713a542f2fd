#pragma once

#include <memory>

namespace stepwire {

struct Value;

#ifdef STEPWIRE_GENERATED
/// Empty in generated code, which only steps.
class Tree {};
#else

/// Parameter of nested maps and lists, read only before a run. The header of a block does not need the
/// definition of Value.
class Tree {
 public:
  /// Makes an empty map.
  Tree() = default;
  explicit Tree(const Value& value);
  Tree(const Tree& other);
  Tree(Tree&&) noexcept = default;
  Tree& operator=(const Tree& other) { return *this = Tree(other); }
  Tree& operator=(Tree&&) noexcept = default;
  ~Tree() = default;

  Value value() const;

 private:
  std::unique_ptr<const Value, void (*)(const Value*)> value_{nullptr, nullptr};
};

#endif

}  // namespace stepwire
