#include "engine/model/block/tree.hpp"

#include "engine/model/block/value.hpp"

namespace stepwire {

Tree::Tree(const Value& value) : value_(new Value(value), [](const Value* owned) { delete owned; }) {}

Tree::Tree(const Tree& other) : Tree(other.value()) {}

Value Tree::value() const {
  return value_ ? *value_ : Value{Value::Map{}};
}

}  // namespace stepwire
