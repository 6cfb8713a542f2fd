#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/block/literal.hpp"

namespace stepwire::plan {

/// Numbers in the members of a block, in the order in which a program writes them. An item is one number or a
/// list of numbers.
class MemberItems : public LiteralWriter {
 public:
  struct Item {
    std::size_t first, size;  ///< range in numbers()
    bool is_list;
  };

  MemberItems() = default;
  /// Collects the items of all members of a block.
  MemberItems(const BlockType& type, const void* block);
  void add(const MemberSpec& member, const void* block);

  const std::vector<Item>& items() const { return items_; }
  const std::vector<double>& numbers() const { return numbers_; }
  /// Returns the structure of the members without their numbers: which lists have one number, and the
  /// functions.
  const std::string& outline() const { return outline_; }
  /// True where the item has the same bits as that of a block with this outline.
  bool same(std::size_t item, const MemberItems& other) const;
  bool operator==(const MemberItems& other) const;

  std::string number(double value) override;
  std::string flag(bool value) override;
  std::string enumerator(int value, const std::string& type) override;
  std::string numbers(const double* values, Index size) override;
  std::string whole(std::int64_t value) override;
  /// Writes a number in two halves, since a double does not hold all of them exactly.
  std::string natural(std::uint64_t value) override;

 private:
  std::string item(std::initializer_list<double> numbers);

  std::vector<Item> items_;
  std::vector<double> numbers_;
  std::string outline_;
};

}  // namespace stepwire::plan
