#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/literal.hpp"

namespace stepwire::codegen {

/// Writes numbers of blocks into a program: as literals, longer lists as tables, and variable ones as
/// `numbers[i]`, counted in the order in which they are written. A variable list begins at an index that is a
/// number itself, so lists may have other lengths from run to run.
class Literals : public LiteralWriter {
 public:
  /// `table` is the name of the variable numbers.
  explicit Literals(std::string table = "numbers") : table_(std::move(table)) {}

  /// Sets for the numbers and lists that are written next which ones are read from `numbers`. Later ones are
  /// not.
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
  /// Between begin_functions() and end_functions(): "Code{2}", whose type has the functions of one block.
  std::string function(const std::string& expression) override;

  /// Sets the name of the next table.
  void name_tables(std::string name) { name_ = std::move(name); }
  /// Returns the definitions of all tables so far.
  std::string tables() const { return tables_; }

  /// Gathers the functions of a block from here on.
  void begin_functions() { gathered_.emplace(); }
  /// Returns the name of the type that has the gathered functions: `name`, or that of an equal earlier one.
  std::string end_functions(const std::string& name);
  /// Returns the definitions of all types of functions so far.
  std::string functions() const { return functions_; }

 private:
  /// Returns "numbers[i]", with the name of the table.
  std::string next();

  /// True if the present item is read from `numbers`.
  bool varies();

  std::string table_;
  std::vector<bool> items_;
  std::size_t item_ = 0;
  std::size_t count_ = 0;  ///< count of variable numbers
  std::string tables_;
  std::string name_;
  std::set<std::string> names_;  ///< names of tables
  std::optional<std::vector<std::string>> gathered_;
  std::map<std::vector<std::string>, std::string> types_;  ///< names by their functions
  std::string functions_;
};

/// Returns a double as C++ that reads back to the same bits: "5.0", "-unlimited".
std::string number_text(double value);

}  // namespace stepwire::codegen
