#include "engine/model/plan/compiled_plan.hpp"

#include <algorithm>

#include "engine/model/block/literal.hpp"

namespace stepwire {

/// Gathers numbers in the order in which a program reads them.
class NumberTable::Writer : public LiteralWriter {
 public:
  std::string number(double value) override { return add(value); }
  std::string flag(bool value) override { return add(value ? 1.0 : 0.0); }
  std::string enumerator(int value, const std::string&) override { return add(value); }
  std::string numbers(const double* values, Index size) override {
    lists.push_back({singles.size(), in_lists.size(), static_cast<std::size_t>(size)});
    in_lists.insert(in_lists.end(), values, values + size);
    return add(0.0);
  }
  std::string whole(std::int64_t value) override { return add(static_cast<double>(value)); }
  /// In two halves, since a double does not hold all of them.
  std::string natural(std::uint64_t value) override {
    add(static_cast<double>(value >> 32));
    return add(static_cast<double>(value & 0xffffffffu));
  }

  std::vector<double> singles, in_lists;
  std::vector<List> lists;

 private:
  std::string add(double value) {
    singles.push_back(value);
    return "";
  }
};

NumberTable::NumberTable(const Plan& plan, const std::vector<VariableBlock>& variable, const Blocks& blocks)
    : plan_(plan), variable_(variable) {
  read_all(blocks);
}

void NumberTable::write(std::size_t variable, const Blocks& blocks, Writer& writer) const {
  const VariableBlock& block = variable_[variable];
  const auto& members = plan_.diagram.blocks[block.block].type().members;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (block.members[m]) members[m].literal(blocks(block.block), writer);
}

void NumberTable::read_all(const Blocks& blocks) {
  Writer all;
  places_.clear();
  for (std::size_t v = 0; v < variable_.size(); ++v) {
    const std::size_t singles = all.singles.size(), lists = all.lists.size();
    write(v, blocks, all);
    places_.push_back({singles, all.singles.size() - singles, lists, all.lists.size() - lists});
  }
  for (List& list : all.lists) {
    list.first += all.singles.size();
    all.singles[list.place] = static_cast<double>(list.first);
  }
  lists_ = std::move(all.lists);
  numbers_ = std::move(all.singles);
  numbers_.insert(numbers_.end(), all.in_lists.begin(), all.in_lists.end());
}

void NumberTable::read(std::size_t variable, const Blocks& blocks) {
  Writer own;
  write(variable, blocks, own);
  const Place& place = places_[variable];
  const auto first = lists_.begin() + static_cast<std::ptrdiff_t>(place.first_list);
  const bool same = own.lists.size() == place.lists &&
                    std::equal(own.lists.begin(), own.lists.end(), first,
                               [](const List& a, const List& b) { return a.size == b.size; });
  if (!same) return read_all(blocks);
  const auto at = [&](std::size_t i) { return numbers_.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t i = 0; i < own.lists.size(); ++i) {
    const List& list = first[static_cast<std::ptrdiff_t>(i)];
    own.singles[own.lists[i].place] = static_cast<double>(list.first);
    std::copy_n(own.in_lists.begin() + static_cast<std::ptrdiff_t>(own.lists[i].first), list.size,
                at(list.first));
  }
  std::copy(own.singles.begin(), own.singles.end(), at(place.first_single));
}

}  // namespace stepwire
