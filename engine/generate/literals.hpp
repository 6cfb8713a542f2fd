#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/block/literal.hpp"

namespace stepwire {

/// Which numbers of a program are parameters, in the order in which they are written: those in which the
/// plans that share the program differ. Lists count by the number that says where they begin.
using Varying = std::vector<bool>;

/// Every number of the blocks: single ones in their order, and behind them the lists.
struct ProgramNumbers {
  struct List {
    std::size_t place;        ///< of the number that says where the list begins
    std::size_t first, size;  ///< where it begins, and how long it is
  };

  std::vector<double> numbers;
  std::vector<List> lists;

  /// How many single numbers there are.
  std::size_t singles() const { return lists.empty() ? numbers.size() : lists.front().first; }
};

/// Writes the numbers of blocks into a program: as they are, longer lists as tables, and numbers that vary as
/// `parameters[i]`. A list that varies begins at the parameter that another one names, so that lists may have
/// other lengths from plan to plan.
class Literals : public LiteralWriter {
 public:
  /// With the numbers themselves.
  Literals() = default;
  /// With `parameters[i]` for what varies.
  explicit Literals(const Varying& varying) : varying_(&varying) {}
  /// With `parameters[i]` for every number.
  static Literals all_varying() {
    Literals literals;
    literals.all_vary_ = true;
    return literals;
  }

  std::string number(double value) override;
  std::string flag(bool value) override;
  std::string enumerator(int value, const std::string& type) override;
  std::string numbers(const double* values, Index size) override;
  std::string whole(std::int64_t value) override;

  /// What the next table is called.
  void name_tables(std::string name) { name_ = std::move(name); }
  /// Definitions of all tables so far.
  std::string tables() const;
  /// Every number written; parameters[i] is the i-th.
  ProgramNumbers all() const;

 private:
  struct Table {
    std::string name;
    std::size_t list;  ///< its index in lists_
  };

  /// "parameters[i]" for the next number where it varies, else nothing.
  std::string parameter(double value);
  bool varies(std::size_t index) const { return all_vary_ || (varying_ && (*varying_)[index]); }

  const Varying* varying_ = nullptr;
  bool all_vary_ = false;
  std::vector<double> singles_;
  std::vector<double> in_lists_;             ///< one list behind the other
  std::vector<ProgramNumbers::List> lists_;  ///< first counts in in_lists_
  std::vector<Table> tables_;
  std::string name_;
  std::set<std::string> names_;  ///< of tables
};

/// A double as C++ that reads back to the same bits: "5.0", "-unlimited".
std::string number_text(double value);

}  // namespace stepwire
