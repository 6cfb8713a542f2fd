#include "engine/model/diagram/parameter_state.hpp"

#include <algorithm>

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

const ParameterSpec& spec_of(const Diagram& diagram, const Target& target) {
  if (target.kind != Target::Kind::parameter) return numbers_of_any_unit();
  return diagram.blocks[static_cast<std::size_t>(target.block)]
      .type()
      .parameters[static_cast<std::size_t>(target.index)];
}

template <class T>
bool contains(const std::vector<T>& all, const T& one) {
  return std::ranges::find(all, one) != all.end();
}

template <class T>
void add(std::vector<T>& all, const T& one) {
  if (!contains(all, one)) all.push_back(one);
}

}  // namespace

/// Evaluation of one call of set().
class ParameterState::Evaluation {
 public:
  explicit Evaluation(ParameterState& state)
      : state_(state), diagram_(state.diagram_), report_(state.diagram_) {}

  void give(const Variation::Name& name, const Assignment& value) {
    report_.call_given(value.place);
    const Origin origin{given_origin, value.value.mark};
    if (name.definition >= 0) {
      const Definition& definition = definition_of(name.definition);
      define(name.definition, {value.value, definition.scope, given_origin}, origin);
      add(state_.set_definitions_, name.definition);
    } else {
      read(name.target, {value.value, diagram_.blocks[block_of(name.target)].origin.scope, given_origin});
      add(state_.set_targets_, name.target);
    }
  }

  void follow(const Variation& variation) {
    for (const int d : variation.definitions())
      if (!contains(state_.set_definitions_, d))
        define(d, definition_of(d).text, {definition_of(d).text.place, definition_of(d).text.node.mark});
    for (const int b : variation.bindings()) {
      const Binding& binding = diagram_.bindings->bindings[static_cast<std::size_t>(b)];
      if (!contains(state_.set_targets_, binding.target)) read(binding.target, binding.text);
    }
  }

  std::vector<ChangedValue> take() {
    report_.faults().throw_if_any();
    return std::move(changed_);
  }

 private:
  static std::size_t block_of(const Target& target) { return static_cast<std::size_t>(target.block); }

  const Definition& definition_of(int index) const {
    return diagram_.bindings->definitions[static_cast<std::size_t>(index)];
  }

  void define(int index, const ValueText& text, const Origin& origin) {
    const Definition& definition = definition_of(index);
    const std::string& full = diagram_.parameters[static_cast<std::size_t>(index)].name;
    ParameterUses uses;
    auto value = ValueReader(state_.scope(text.names), report_, text.place, &uses).read(text.node, full);
    if (value) note_giver(*value, definition, full, origin);
    if (value && accepts(definition, state_.scope(definition.scope), *value, origin, full, uses, report_))
      state_.replace(definition, std::move(*value));
  }

  void read(const Target& target, const ValueText& text) {
    const ParameterSpec& spec = spec_of(diagram_, target);
    ParameterUses uses;
    const ValueReader reader(state_.scope(text.names), report_, text.place, &uses);
    auto value = reader.read_for(spec, demanded_dimension(spec), text.node, name_of(diagram_, target));
    if (value) changed_.push_back({target, std::move(*value), {text.place, text.node.mark}});
  }

  ParameterState& state_;
  const Diagram& diagram_;
  FaultReport report_;
  std::vector<ChangedValue> changed_;
};

std::vector<ChangedValue> ParameterState::set(const Variation& variation,
                                              std::span<const Assignment> values) {
  before_.clear();
  definitions_before_ = set_definitions_.size();
  targets_before_ = set_targets_.size();
  try {
    Evaluation evaluation(*this);
    for (std::size_t i = 0; i < values.size(); ++i) evaluation.give(variation.names()[i], values[i]);
    evaluation.follow(variation);
    return evaluation.take();
  } catch (...) {
    undo();
    throw;
  }
}

const Value* ParameterState::value(std::size_t definition) const {
  const Definition& known = diagram_.bindings->definitions[definition];
  const auto scope = scopes_.find(known.scope);
  return scope == scopes_.end() ? nullptr : scope->second.value(known.name);
}

void ParameterState::undo() {
  for (; !before_.empty(); before_.pop_back()) {
    auto& [definition, value] = before_.back();
    scope(definition->scope).replace(definition->name, std::move(value));
  }
  set_definitions_.resize(definitions_before_);
  set_targets_.resize(targets_before_);
}

ParameterScope& ParameterState::scope(int index) {
  const auto found = scopes_.find(index);
  if (found != scopes_.end()) return found->second;
  return scopes_.emplace(index, diagram_.bindings->scopes[static_cast<std::size_t>(index)]).first->second;
}

void ParameterState::replace(const Definition& definition, WrittenValue value) {
  before_.emplace_back(&definition, scope(definition.scope).replace(definition.name, std::move(value)));
}

}  // namespace stepwire::diagram
