#include "engine/model/plan/member_items.hpp"

#include <cstring>

namespace stepwire::plan {

MemberItems::MemberItems(const BlockType& type, const void* block) {
  for (const MemberSpec& member : type.members) add(member, block);
}

void MemberItems::add(const MemberSpec& member, const void* block) {
  outline_ += member.literal(block, *this) + ";";
}

bool MemberItems::same(std::size_t item, const MemberItems& other) const {
  const Item &own = items_[item], &its = other.items_[item];
  return own.size == its.size && own.is_list == its.is_list &&
         (own.size == 0 || std::memcmp(numbers_.data() + own.first, other.numbers_.data() + its.first,
                                       own.size * sizeof(double)) == 0);
}

bool MemberItems::operator==(const MemberItems& other) const {
  if (outline_ != other.outline_ || items_.size() != other.items_.size()) return false;
  for (std::size_t i = 0; i < items_.size(); ++i)
    if (!same(i, other)) return false;
  return true;
}

std::string MemberItems::item(std::initializer_list<double> numbers) {
  items_.push_back({numbers_.size(), numbers.size(), false});
  numbers_.insert(numbers_.end(), numbers);
  return "";
}

std::string MemberItems::number(double value) {
  return item({value});
}

std::string MemberItems::flag(bool value) {
  return item({value ? 1.0 : 0.0});
}

std::string MemberItems::enumerator(int value, const std::string&) {
  return item({static_cast<double>(value)});
}

std::string MemberItems::numbers(const double* values, Index size) {
  items_.push_back({numbers_.size(), static_cast<std::size_t>(size), true});
  numbers_.insert(numbers_.end(), values, values + size);
  return "";
}

std::string MemberItems::whole(std::int64_t value) {
  return item({static_cast<double>(value)});
}

std::string MemberItems::natural(std::uint64_t value) {
  return item({static_cast<double>(value >> 32), static_cast<double>(value & 0xffffffffu)});
}

}  // namespace stepwire::plan
