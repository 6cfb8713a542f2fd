#pragma once

#include <string>
#include <vector>

#include "engine/block/literal.hpp"

namespace stepwire {

/// Which numbers of a program are parameters, in the order in which they are written: those in which the
/// plans that share the program differ.
using Varying = std::vector<bool>;

/// Where long lists of numbers, such as records, stand among the numbers of a program.
enum class Lists {
  in_place,  ///< as any other numbers: programs whose lists differ in length share nothing
  apart      ///< behind all others, with their places and lengths among these
};

/// Writes the numbers of blocks into a program: as they are, longer lists as tables, and numbers that vary as
/// `parameters[i]`.
class Literals : public LiteralWriter {
 public:
  /// With the numbers themselves.
  explicit Literals(Lists lists = Lists::in_place) : lists_(lists) {}
  /// With `parameters[i]` for what varies.
  explicit Literals(const Varying& varying, Lists lists = Lists::in_place)
      : varying_(&varying), lists_(lists) {}

  std::string number(double value) override;
  std::string flag(bool value) override;
  std::string enumerator(int value, const std::string& type) override;
  std::string numbers(const double* values, Index size) override;
  std::string count(Index count) override;

  /// What the next table is called.
  void name_tables(std::string name) {
    name_ = std::move(name);
    in_name_ = 0;
  }
  /// Definitions of all tables so far.
  const std::string& tables() const { return tables_; }
  /// Every number written, in order; parameters[i] is the i-th.
  std::vector<double> all() const;
  /// How many of them stand in front of the lists that stand apart.
  std::size_t before_lists() const { return all_.size(); }

 private:
  /// "parameters[i]" for the next number where it varies, else nothing.
  std::string parameter(double value);
  bool varies(std::size_t index) const { return varying_ && (*varying_)[index]; }

  bool stands_apart(Index size) const { return lists_ == Lists::apart && size >= longest_in_place; }
  /// A pointer to numbers behind all others.
  std::string put_apart(const double* values, Index size);

  static constexpr Index longest_in_place = 64;  // what is shorter, code may be made for

  const Varying* varying_ = nullptr;
  Lists lists_;
  std::vector<double> all_, apart_;
  std::vector<std::size_t> places_;  ///< in all_, of where lists begin in apart_
  std::string name_, tables_;
  int in_name_ = 0;
};

/// A double as C++ that reads back to the same bits: "5.0", "-unlimited".
std::string number_text(double value);

}  // namespace stepwire
