#include <utility>

#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

const WrittenValue* ParameterScope::find(const std::string& name, ParameterUses* uses) const {
  const auto found = values_.find(name);
  if (found == values_.end()) return nullptr;
  const Entry& entry = found->second;
  entry.used = true;
  if (uses && entry.index >= 0)
    uses->push_back(entry.index);
  else
    entry.structural = true;
  return &entry.value;
}

void ParameterScope::define(const std::string& name, WrittenValue value, int index) {
  values_[name] = {std::move(value), index};
}

WrittenValue ParameterScope::replace(const std::string& name, WrittenValue value) {
  return std::exchange(values_.at(name).value, std::move(value));
}

const Value* ParameterScope::value(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second.value.value;
}

bool ParameterScope::failed(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.value.failed;
}

bool ParameterScope::used(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.used;
}

bool ParameterScope::is_structural(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && found->second.structural;
}

std::vector<std::string> ParameterScope::names() const {
  std::vector<std::string> result;
  for (const auto& [name, entry] : values_) result.push_back(name);
  return result;
}

bool ParameterScope::knows(const std::string& name) const {
  std::string whole = name;
  return defined(name) || (!take_element(whole).is_whole() && defined(whole));
}

const expression::Expression* ParameterScope::expression(const std::string& text) const {
  const auto known = [this](std::string_view name) { return knows(std::string(name)); };
  const auto [found, is_new] = expressions_.try_emplace(text);
  if (!is_new) return found->second ? &*found->second : nullptr;
  try {
    found->second.emplace(text, known);
  } catch (const expression::ExpressionError&) {
    expressions_.erase(found);
    matrix_expression(text);  // throws for an invalid matrix expression as well
    expressions_.try_emplace(text);
    return nullptr;
  }
  return &*found->second;
}

const expression::MatrixExpression& ParameterScope::matrix_expression(const std::string& text) const {
  const auto found = matrix_expressions_.find(text);
  if (found != matrix_expressions_.end()) return found->second;
  const auto known = [this](std::string_view name) { return knows(std::string(name)); };
  return matrix_expressions_.emplace(text, expression::MatrixExpression(text, known)).first->second;
}

}  // namespace stepwire::diagram
