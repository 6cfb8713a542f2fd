#pragma once

#include <memory>

namespace stepwire {

struct Value;

#ifdef STEPWIRE_GENERATED
/// Nothing of it is left in generated code, which only steps.
class Tree {};
#else

/// Maps and lists that a block is given and reads before a run only: a parameter. What they are made of, a
/// block's header need not know.
class Tree {
 public:
  /// An empty map.
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
