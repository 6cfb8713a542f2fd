#include "engine/model/plan/variable_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/model/plan/change.hpp"
#include "engine/model/plan/member_items.hpp"

namespace stepwire {

namespace {

using Items = std::vector<bool>;

const AnyBlock& block_of(const Plan& plan, std::size_t block) {
  return plan.diagram.blocks[block].block;
}

void mark_differences(const MemberItems& one, const MemberItems& other, Items& items) {
  if (one.outline() != other.outline()) return;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!items[i] && !one.same(i, other)) items[i] = true;
}

/// By how much a value is moved.
struct Step {
  double part, whole;  ///< of the value; beside that, for whole numbers
};
constexpr Step steps[] = {{1e-3, 0.0}, {-1e-3, 0.0}, {0.0, 1.0}, {0.0, -1.0}};

/// Elements of a list go each another way, so that what follows from their ratios moves as well.
std::optional<Value> moved(Value value, const Step& step) {
  const auto move = [&](double& number, double share) {
    number += step.whole + step.part * share * (number == 0.0 ? 1.0 : std::abs(number));
  };
  const auto move_all = [&](auto& list) {
    for (Eigen::Index i = 0; i < list.size(); ++i)
      move(list.data()[i], 1.0 + 0.1 * static_cast<double>(i % 7));
  };
  if (auto* number = std::get_if<double>(&value.content))
    move(*number, 1.0);
  else if (auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    move_all(*vector);
  else if (auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    move_all(*matrix);
  else
    return std::nullopt;
  return value;
}

/// Finds what follows from parameters of a plan's blocks.
class Followers {
 public:
  explicit Followers(const Plan& plan) : plan_(plan) {}

  void add(const Target& target) {
    const auto block = static_cast<std::size_t>(target.block);
    const MemberItems own(block_of(plan_, block).type(), block_of(plan_, block).get());
    Items& items = items_.try_emplace(block, Items(own.items().size(), false)).first->second;
    for (const Step& step : steps)
      if (moves(target, step, own, items)) return;
    mark_all(target, items);
  }

  std::vector<VariableBlock> take() {
    std::vector<VariableBlock> result;
    for (const int block : plan_.memory_order)
      if (const auto found = items_.find(static_cast<std::size_t>(block)); found != items_.end())
        result.push_back({found->first, std::move(found->second)});
    return result;
  }

 private:
  /// False where the value cannot be moved, or not that way.
  bool moves(const Target& target, const Step& step, const MemberItems& own, Items& items) const {
    const auto block = static_cast<std::size_t>(target.block);
    const auto& planned = plan_.blocks[block].written;
    const AnyBlock& written = planned ? *planned : block_of(plan_, block);
    const auto& spec = written.type().parameters[static_cast<std::size_t>(target.index)];
    try {
      const auto value = moved(spec.get(written.get()), step);
      if (!value || spec.member < 0) return false;
      const PlanChange change = change_of(plan_, {{target, {*value, {}, {}}, {}}}, {});
      if (!change.structure.empty() || !has_moved(spec, change.blocks.front().written, written)) return false;
      for (const RebuiltBlock& rebuilt : change.blocks)
        mark_differences(own, MemberItems(rebuilt.made.type(), rebuilt.made.get()), items);
      return true;
    } catch (const Error&) {  // the value is at a limit
      return false;
    }
  }

  /// A whole number is not moved by a part of it.
  static bool has_moved(const ParameterSpec& spec, const AnyBlock& one, const AnyBlock& other) {
    const MemberSpec& member = one.type().members[static_cast<std::size_t>(spec.member)];
    MemberItems a, b;
    a.add(member, one.get());
    b.add(member, other.get());
    return !(a == b);
  }

  /// Marks the parameter itself and what configure() and prepare() compute.
  void mark_all(const Target& target, Items& items) const {
    const AnyBlock& block = block_of(plan_, static_cast<std::size_t>(target.block));
    const auto& parameters = block.type().parameters;
    const auto& members = block.type().members;
    std::vector<bool> kept(members.size(), !plan_.blocks[static_cast<std::size_t>(target.block)].written);
    for (const ParameterSpec& spec : parameters)
      if (spec.member >= 0) kept[static_cast<std::size_t>(spec.member)] = true;
    const int own = parameters[static_cast<std::size_t>(target.index)].member;
    if (own >= 0) kept[static_cast<std::size_t>(own)] = false;
    MemberItems before;
    for (std::size_t m = 0; m < members.size(); ++m) {
      const std::size_t first = before.items().size();
      before.add(members[m], block.get());
      if (!kept[m])
        std::fill(items.begin() + static_cast<std::ptrdiff_t>(first),
                  items.begin() + static_cast<std::ptrdiff_t>(before.items().size()), true);
    }
  }

  const Plan& plan_;
  std::map<std::size_t, Items> items_;  ///< by block
};

}  // namespace

std::vector<VariableBlock> variable_blocks(const Plan& plan, const Variation& variation) {
  Followers followers(plan);
  for (const Target& target : variation.targets())
    if (target.kind == Target::Kind::parameter) followers.add(target);
  return followers.take();
}

void unite(std::vector<VariableBlock>& variable, const Plan& plan, const std::vector<VariableBlock>& more) {
  for (const VariableBlock& one : more) {
    const auto known = std::ranges::find(variable, one.block, &VariableBlock::block);
    if (known == variable.end()) {
      variable.push_back(one);
      continue;
    }
    for (std::size_t i = 0; i < one.items.size(); ++i)
      if (one.items[i]) known->items[i] = true;
  }
  std::ranges::sort(variable, {}, [&](const VariableBlock& one) { return plan.blocks[one.block].memory; });
}

void widen(std::vector<VariableBlock>& variable, const Plan& plan, const BlocksOfRun& blocks) {
  for (VariableBlock& one : variable) {
    if (std::ranges::all_of(one.items, [](bool varies) { return varies; })) continue;
    const AnyBlock& own = block_of(plan, one.block);
    mark_differences(MemberItems(own.type(), own.get()), MemberItems(own.type(), blocks(one.block)),
                     one.items);
  }
}

}  // namespace stepwire
