#include "engine/simulate/codegen/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/member_items.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/fixed_values.hpp"
#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

/// Marker numbers that no diagram contains. They replace the variable numbers, so that the places that depend
/// on them can be found.
class Marks {
 public:
  static constexpr double first = 7.0e14;

  double next(const PreparedBlock::Number& prepared, const Tuning::Copy& copy, std::size_t block) {
    all_.push_back({prepared, copy, block});
    return first + static_cast<double>(all_.size() - 1);
  }

  struct Mark {
    PreparedBlock::Number prepared;
    Tuning::Copy copy;
    std::size_t block;  ///< block that prepares it; `none` for a copy
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Mark* of(double number) const {
    const double index = number - first;
    return index >= 0.0 && index < static_cast<double>(all_.size()) ? &all_[static_cast<std::size_t>(index)]
                                                                    : nullptr;
  }

 private:
  std::vector<Mark> all_;
};

void put_numbers(Value& value, const std::vector<double>& numbers) {
  if (auto* number = std::get_if<double>(&value.content)) *number = numbers.front();
  if (auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    std::copy(numbers.begin(), numbers.end(), vector->data());
  if (auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    std::copy(numbers.begin(), numbers.end(), matrix->data());
}

/// Returns the items of these members of a block.
std::vector<bool> items_of(const std::vector<bool>& members, const AnyBlock& block) {
  std::vector<bool> items;
  for (std::size_t m = 0; m < members.size(); ++m) {
    plan::MemberItems of_member;
    of_member.add(block.type().members[m], block.get());
    items.insert(items.end(), of_member.items().size(), members[m]);
  }
  return items;
}

class Tuner {
 public:
  explicit Tuner(const plan::Plan& plan) : plan_(plan), all_(*plan.diagram.bindings) {}

  Tuning take() {
    choose();
    if (tuning_.parameters.empty()) return std::move(tuning_);
    gather_bindings();
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) take_parameter(i);
    for (const int block : plan_.memory_order) take_block(static_cast<std::size_t>(block));
    place_numbers();
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) take_place(i);
    return std::move(tuning_);
  }

 private:
  const diagram::Binding& binding(std::size_t i) const {
    return all_.bindings[static_cast<std::size_t>(tuning_.bindings[i])];
  }

  void choose() {
    const FixedValues fixed(plan_);
    std::set<std::string> taken;
    for (std::size_t d = 0; d < plan_.diagram.parameters.size(); ++d) {
      const std::string& name = plan_.diagram.parameters[d].name;
      if (const std::string reason = fixed.reason(d); !reason.empty()) {
        tuning_.fixed.push_back({name, reason});
        continue;
      }
      tuning_.parameters.push_back(static_cast<int>(d));
      tuning_.members[static_cast<int>(d)] = free_member(name, taken);
    }
  }

  void gather_bindings() {
    for (std::size_t b = 0; b < all_.bindings.size(); ++b)
      if (std::ranges::any_of(all_.bindings[b].uses, [&](int d) { return follows(d); }))
        tuning_.bindings.push_back(static_cast<int>(b));
  }

  /// True for a parameter that may change.
  bool follows(int definition) const { return tuning_.members.contains(definition); }

  const BlockType& type(std::size_t block) const { return plan_.diagram.blocks[block].type(); }

  AnyBlock& marked(std::size_t block) {
    return marked_.try_emplace(block, plan_.diagram.blocks[block].block).first->second;
  }

  /// Marks the numbers of a block's parameter.
  void take_parameter(std::size_t i) {
    const diagram::Target& target = binding(i).target;
    if (target.kind != diagram::Target::Kind::parameter) return;
    const auto block = static_cast<std::size_t>(target.block);
    const ParameterSpec& spec = type(block).parameters[static_cast<std::size_t>(target.index)];
    std::vector<bool>& members = members_[block];
    members.resize(type(block).members.size(), false);
    if (spec.member < 0) return;
    members[static_cast<std::size_t>(spec.member)] = true;
    Value value = spec.get(marked(block).get());
    std::vector<double> marks;
    for (std::size_t k = 0; k < numbers_of(value).size(); ++k)
      marks.push_back(marks_.next({}, {0, i, k}, Marks::none));
    put_numbers(value, marks);
    spec.set(marked(block).get(), value);
  }

  /// Marks the numbers that a block prepares, in memory order.
  void take_block(std::size_t block) {
    const auto found = members_.find(block);
    if (found == members_.end()) return;
    const AnyBlock& of_plan = plan_.diagram.blocks[block].block;
    for (std::size_t m = 0; m < type(block).members.size() && can_prepare(of_plan); ++m) {
      const PreparedMember& prepared = type(block).members[m].prepared;
      if (!prepared.put) continue;
      found->second[m] = true;
      std::vector<double> marks;
      for (std::size_t k = 0; k < static_cast<std::size_t>(prepared.count(of_plan.get())); ++k)
        marks.push_back(marks_.next({0, m, k}, {}, block));
      prepared.put(marked(block).get(), marks.data(), static_cast<Index>(marks.size()));
    }
    tuning_.variable.push_back({block, items_of(found->second, of_plan)});
  }

  void place_numbers() {
    const plan::NumberTable actual(plan_, tuning_.variable,
                                   [&](std::size_t b) { return plan_.diagram.blocks[b].block.get(); });
    const plan::NumberTable table(plan_, tuning_.variable, [&](std::size_t b) { return marked(b).get(); });
    tuning_.numbers.assign(actual.data(), actual.data() + actual.size());
    std::map<std::size_t, PreparedBlock> prepared;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const Marks::Mark* mark = marks_.of(table.data()[i]);
      if (!mark) continue;
      if (mark->block == Marks::none) {
        tuning_.copies.push_back({i, mark->copy.binding, mark->copy.element});
      } else {
        prepared[mark->block].block = mark->block;
        prepared[mark->block].numbers.push_back({i, mark->prepared.member, mark->prepared.part});
      }
    }
    for (auto& [block, one] : prepared) tuning_.prepared.push_back(std::move(one));
  }

  /// Adds the numbers of constants on wires and of initial values, after those of blocks.
  void take_place(std::size_t i) {
    const diagram::Target& target = binding(i).target;
    if (target.kind == diagram::Target::Kind::parameter) return;
    const plan::PlannedBlock& planned = plan_.blocks[static_cast<std::size_t>(target.block)];
    const auto index = static_cast<std::size_t>(target.index);
    const bool is_state = target.kind == diagram::Target::Kind::initial;
    const plan::SignalSlot& slot =
        is_state ? planned.states[index] : planned.inputs[index][static_cast<std::size_t>(target.element)];
    const std::size_t first = is_state ? 0 : first_meant(target);
    for (std::size_t k = 0; k < static_cast<std::size_t>(slot.size); ++k) {
      tuning_.places[slot.offset + k] = tuning_.numbers.size();
      if (is_state && !planned.initial.empty())  // a guard resets it
        tuning_.places[planned.initial[index].offset + k] = tuning_.numbers.size();
      tuning_.copies.push_back({tuning_.numbers.size(), i, first + k});
      tuning_.numbers.push_back(is_state ? initial(target, k)
                                         : plan_.constants[slot.offset - plan_.layout.constants + k]);
    }
  }

  /// Returns the index of the first number of a constant on a wire that the target sets.
  std::size_t first_meant(const diagram::Target& target) const {
    return plan::constant_slot(
               plan_.diagram.blocks[static_cast<std::size_t>(target.block)]
                   .inputs[static_cast<std::size_t>(target.index)][static_cast<std::size_t>(target.element)])
        .offset;
  }

  double initial(const diagram::Target& target, std::size_t k) const {
    for (const diagram::InitialValue& one :
         plan_.diagram.blocks[static_cast<std::size_t>(target.block)].initial)
      if (one.state == target.index)
        return one.value[one.value.size() == 1 ? 0 : static_cast<Eigen::Index>(k)];
    return 0.0;
  }

  const plan::Plan& plan_;
  const diagram::Bindings& all_;
  Tuning tuning_;
  Marks marks_;
  std::map<std::size_t, AnyBlock> marked_;
  std::map<std::size_t, std::vector<bool>> members_;
};

}  // namespace

Tuning tuning_of(const plan::Plan& plan) {
  return Tuner(plan).take();
}

}  // namespace stepwire::codegen
