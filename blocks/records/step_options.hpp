#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blocks/records/record.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Keys of one step of a preparation in the file. Every reader refuses any other value, with its place.
class StepOptions {
 public:
  /// Function that throws a message for a piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;

  /// `step` is a map with the key `name`; `example` is an example of such a step.
  StepOptions(const Value& step, std::string_view name, std::string_view example, const Refuse& refuse)
      : step_(step), name_(name), example_(example), refuse_(refuse) {}

  bool has(std::string_view key) const { return step_.find(key) != nullptr; }
  std::string text(std::string_view key) const;
  /// Returns a number in SI, whose unit must have this dimension if it has one. Without a dimension any unit
  /// is accepted.
  double number(std::string_view key, const std::optional<unit::Dimension>& dimension) const;
  double positive(std::string_view key, const unit::Dimension& dimension) const;
  /// Returns an integer from `least` to `most`.
  Index whole(std::string_view key, Index least, Index most) const;
  /// Returns the index of the value among the words.
  std::size_t word(std::string_view key, const std::vector<std::string>& words) const;

  /// Throws "prepare: low_pass: MESSAGE", at the key or at the whole step.
  [[noreturn]] void refuse(std::string_view key, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& message) const;
  /// Refuses a record with unevenly spaced rows, with the first uneven one and the cure.
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
