#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/block/literal.hpp"

namespace stepwire::plan {

/// The numbers that a block's members hold, in the order in which a program writes them: an item is one
/// number, or a list of them.
class MemberItems : public LiteralWriter {
 public:
  struct Item {
    std::size_t first, size;  ///< in numbers()
    bool is_list;
  };

  MemberItems() = default;
  /// Of all members of a block.
  MemberItems(const BlockType& type, const void* block);
  void add(const MemberSpec& member, const void* block);

  const std::vector<Item>& items() const { return items_; }
  const std::vector<double>& numbers() const { return numbers_; }
  /// What the members are beside their numbers: lists of one number, or of none or more, and functions.
  const std::string& outline() const { return outline_; }
  /// Has the item the same bits as that of another block with this outline?
  bool same(std::size_t item, const MemberItems& other) const;
  bool operator==(const MemberItems& other) const;

  std::string number(double value) override;
  std::string flag(bool value) override;
  std::string enumerator(int value, const std::string& type) override;
  std::string numbers(const double* values, Index size) override;
  std::string whole(std::int64_t value) override;
  /// In two halves, since a double does not hold all of them.
  std::string natural(std::uint64_t value) override;

 private:
  std::string item(std::initializer_list<double> numbers);

  std::vector<Item> items_;
  std::vector<double> numbers_;
  std::string outline_;
};

}  // namespace stepwire::plan
