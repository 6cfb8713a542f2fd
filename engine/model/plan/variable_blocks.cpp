#include "engine/model/plan/variable_blocks.hpp"

#include <algorithm>
#include <map>

#include "engine/model/plan/member_items.hpp"

namespace stepwire::plan {

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

/// Returns the members that depend on a parameter: its own, and all that configure() or prepare() compute.
std::vector<bool> followers_of(const Plan& plan, const diagram::Target& target) {
  const auto block = static_cast<std::size_t>(target.block);
  const BlockType& type = block_of(plan, block).type();
  std::vector<bool> follow(type.members.size(), plan.blocks[block].written.has_value());
  for (const ParameterSpec& spec : type.parameters)
    if (spec.member >= 0) follow[static_cast<std::size_t>(spec.member)] = false;
  const int own = type.parameters[static_cast<std::size_t>(target.index)].member;
  if (own >= 0) follow[static_cast<std::size_t>(own)] = true;
  return follow;
}

/// Marks the items of a member that may vary within one plan: all but the lengths of its lists. A whole
/// number beside other items is such a length.
class Values : public LiteralWriter {
 public:
  Values(const MemberSpec& member, const void* block) {
    static_cast<void>(member.literal(block, *this));
    if (wholes_.size() == 1) wholes_[0] = false;
  }

  std::size_t size() const { return wholes_.size(); }
  bool operator[](std::size_t item) const { return !wholes_[item]; }

  std::string number(double) override { return item(false); }
  std::string flag(bool) override { return item(false); }
  std::string enumerator(int, const std::string&) override { return item(false); }
  std::string numbers(const double*, Index) override { return item(false); }
  std::string whole(std::int64_t) override { return item(true); }
  std::string natural(std::uint64_t) override { return item(false); }

 private:
  std::string item(bool whole) {
    wholes_.push_back(whole);
    return "";
  }

  Items wholes_;
};

void mark(const AnyBlock& block, const std::vector<bool>& members, Items& items) {
  std::size_t at = 0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Values values(block.type().members[m], block.get());
    items.resize(std::max(items.size(), at + values.size()), false);
    for (std::size_t i = 0; i < values.size(); ++i, ++at)
      if (members[m] && values[i]) items[at] = true;
  }
}

}  // namespace

std::vector<VariableBlock> variable_blocks(const Plan& plan, const diagram::Variation& variation) {
  std::map<std::size_t, Items> items;  // by block
  for (const diagram::Target& target : variation.targets())
    if (target.kind == diagram::Target::Kind::parameter)
      mark(block_of(plan, static_cast<std::size_t>(target.block)), followers_of(plan, target),
           items[static_cast<std::size_t>(target.block)]);
  std::vector<VariableBlock> result;
  for (const int block : plan.memory_order)
    if (const auto found = items.find(static_cast<std::size_t>(block)); found != items.end())
      result.push_back({found->first, std::move(found->second)});
  return result;
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

}  // namespace stepwire::plan
