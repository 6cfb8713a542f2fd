#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/literal.hpp"

namespace stepwire::codegen {

/// Writes numbers of blocks into a program: as they are, longer lists as tables, or as `numbers[i]`, counted
/// in the order in which they are written. A list that varies begins at the number that another one names, so
/// that lists may have other lengths from run to run.
class Literals : public LiteralWriter {
 public:
  /// `table` names the numbers that vary.
  explicit Literals(std::string table = "numbers") : table_(std::move(table)) {}

  /// Of the numbers and lists that are written next, which are read from `numbers`? Those behind the last of
  /// these are not.
  void vary(std::vector<bool> items) {
    items_ = std::move(items);
    item_ = 0;
  }

  std::string number(double value) override;
  std::string flag(bool value) override;
  std::string enumerator(int value, const std::string& type) override;
  std::string numbers(const double* values, Index size) override;
  std::string whole(std::int64_t value) override;
  std::string natural(std::uint64_t value) override;

  /// How many that vary have been written.
  std::size_t varied() const { return count_; }

  /// What the next table is called.
  void name_tables(std::string name) { name_ = std::move(name); }
  /// Definitions of all tables so far.
  std::string tables() const { return tables_; }

 private:
  /// "numbers[i]", or what the table is called
  std::string next();

  /// Is the item that is written now read from `numbers`?
  bool varies();

  std::string table_;
  std::vector<bool> items_;
  std::size_t item_ = 0;
  std::size_t count_ = 0;  ///< of numbers that vary
  std::string tables_;
  std::string name_;
  std::set<std::string> names_;  ///< of tables
};

/// A double as C++ that reads back to the same bits: "5.0", "-unlimited".
std::string number_text(double value);

}  // namespace stepwire::codegen
