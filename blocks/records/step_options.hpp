#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blocks/records/record.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// The keys of one step of a preparation as the file gives them. Every reader refuses, with the place, what
/// is none of what it reads.
class StepOptions {
 public:
  /// `refuse` throws: what is wrong, and with which piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;

  /// `step` is a map that has the key `name`; `example` shows such a step.
  StepOptions(const Value& step, std::string_view name, std::string_view example, const Refuse& refuse)
      : step_(step), name_(name), example_(example), refuse_(refuse) {}

  bool has(std::string_view key) const { return step_.find(key) != nullptr; }
  std::string text(std::string_view key) const;
  /// A number in SI, whose unit must be of this dimension if it has one. Where there is none to compare with,
  /// any unit goes.
  double number(std::string_view key, const std::optional<unit::Dimension>& dimension) const;
  double positive(std::string_view key, const unit::Dimension& dimension) const;
  /// A whole number from `least` to `most`.
  Index whole(std::string_view key, Index least, Index most) const;
  /// Index of the word that stands there.
  std::size_t word(std::string_view key, const std::vector<std::string>& words) const;

  /// Throws: "prepare: low_pass: MESSAGE", at the key or at the whole step.
  [[noreturn]] void refuse(std::string_view key, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& message) const;
  /// Refuses a record whose rows are not evenly spaced, with the row that is not and the cure.
  void require_even(const Record& record) const;
  /// Refuses a record with fewer rows.
  void require_rows(const Record& record, Index least, const std::string& reason) const;

 private:
  [[noreturn]] void refuse(const std::string& message, const Value& where) const;

  const Value& step_;
  std::string name_, example_;
  const Refuse& refuse_;
};

}  // namespace stepwire
