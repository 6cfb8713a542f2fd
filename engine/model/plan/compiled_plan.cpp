#include "engine/model/plan/compiled_plan.hpp"

#include <algorithm>

namespace stepwire::plan {

namespace {

/// True where all items that do not vary equal those of the plan.
bool fits(const std::vector<bool>& varies, const MemberItems& plan, const MemberItems& run) {
  if (plan.outline() != run.outline()) return false;
  for (std::size_t i = 0; i < plan.items().size(); ++i)
    if (!(i < varies.size() && varies[i]) && !plan.same(i, run)) return false;
  return true;
}

}  // namespace

NumberTable::NumberTable(const Plan& plan, const std::vector<VariableBlock>& variable, BlocksOfRun blocks)
    : plan_(plan), variable_(variable), blocks_(std::move(blocks)) {
  for (const VariableBlock& one : variable)
    entries_.push_back(entry_of(one, MemberItems(plan.diagram.blocks[one.block].type(), blocks_(one.block))));
  lay_out();
}

NumberTable::Entry NumberTable::entry_of(const VariableBlock& variable, const MemberItems& items) const {
  Entry entry;
  for (std::size_t i = 0; i < items.items().size(); ++i) {
    if (!variable.items[i]) continue;
    const MemberItems::Item& item = items.items()[i];
    const auto first = items.numbers().begin() + static_cast<std::ptrdiff_t>(item.first);
    const auto end = first + static_cast<std::ptrdiff_t>(item.size);
    if (!item.is_list) {
      entry.singles.insert(entry.singles.end(), first, end);
      continue;
    }
    entry.lists.push_back({entry.singles.size(), entry.in_lists.size(), item.size});
    entry.in_lists.insert(entry.in_lists.end(), first, end);
    entry.singles.push_back(0.0);
  }
  return entry;
}

std::size_t NumberTable::singles() const {
  std::size_t count = 0;
  for (const Entry& entry : entries_) count += entry.singles.size();
  return count;
}

void NumberTable::lay_out() {
  std::size_t list = singles();
  numbers_.clear();
  for (const Entry& entry : entries_) {
    const std::size_t first = numbers_.size();
    numbers_.insert(numbers_.end(), entry.singles.begin(), entry.singles.end());
    for (const List& one : entry.lists) numbers_[first + one.place] = static_cast<double>(list + one.first);
    list += entry.in_lists.size();
  }
  for (const Entry& entry : entries_)
    numbers_.insert(numbers_.end(), entry.in_lists.begin(), entry.in_lists.end());
}

std::vector<std::size_t> NumberTable::list_places() const {
  std::vector<std::size_t> places;
  std::size_t first = 0;
  for (const Entry& entry : entries_) {
    for (const List& one : entry.lists) places.push_back(first + one.place);
    first += entry.singles.size();
  }
  return places;
}

bool NumberTable::read(std::size_t block) {
  const AnyBlock& own = plan_.diagram.blocks[block].block;
  const MemberItems planned(own.type(), own.get()), run(own.type(), blocks_(block));
  const auto found = std::ranges::find(variable_, block, &VariableBlock::block);
  if (found == variable_.end()) return fits({}, planned, run);
  if (!fits(found->items, planned, run)) return false;
  entries_[static_cast<std::size_t>(found - variable_.begin())] = entry_of(*found, run);
  lay_out();
  return true;
}

}  // namespace stepwire::plan
