#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace stepwire::json {

/// A text that is no JSON, or nested deeper than is read.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A JSON value: null, true or false, a number, text, a list, or an object that keeps its
/// order.
///   Json::object().set("that", "the lag settles").set("holds", true).set("value", 0.667)
class Json {
 public:
  Json() = default;
  Json(std::nullptr_t) {}
  Json(std::same_as<bool> auto value) : value_(value) {}
  Json(std::floating_point auto value) : value_(static_cast<double>(value)) {}
  Json(std::signed_integral auto value) : value_(static_cast<std::int64_t>(value)) {}
  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool>) Json(T value) : value_(static_cast<std::uint64_t>(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}

  static Json list(std::vector<Json> items = {});
  static Json object();
  /// A list of anything that a value can be made of: names, numbers.
  template <class Range>
  static Json list_of(const Range& range) {
    Json result = list();
    for (const auto& item : range) result.push(Json(item));
    return result;
  }

  /// Appends to a list; null becomes a list. Throws std::logic_error for anything else.
  Json& push(Json item);
  /// Appends to an object, or replaces what the key has; null becomes an object. Throws std::logic_error for
  /// anything else.
  Json& set(std::string key, Json value);

  /// Reads one value. Throws JsonError.
  static Json parse(std::string_view text);

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  bool is_list() const { return std::holds_alternative<std::vector<Json>>(value_); }
  bool is_object() const { return std::holds_alternative<Members>(value_); }
  /// The items of a list; none of anything else.
  std::span<const Json> items() const;
  /// What an object has, in its order; none of anything else.
  std::span<const std::pair<std::string, Json>> members() const;
  /// What an object has under a key; nullptr where it has not, or where this is no object.
  const Json* find(std::string_view key) const;
  /// The string; nullptr where this is none.
  const std::string* as_text() const { return std::get_if<std::string>(&value_); }
  /// The number; nothing where this is none.
  std::optional<double> as_number() const;
  std::optional<bool> as_flag() const;

  /// Doubles in digits that read back to the same bits, nan and inf as null; `indent` blanks per level, all
  /// on one line where it is negative. Bytes that are no UTF-8 are replaced.
  std::string text(int indent = 2) const;

 private:
  /// Keys and values in their order. Those of many keys have an index, so that none is looked for among all.
  class Members {
   public:
    const std::vector<std::pair<std::string, Json>>& all() const { return pairs_; }
    Json* find(std::string_view key);
    const Json* find(std::string_view key) const { return const_cast<Members*>(this)->find(key); }
    /// A key that it does not have.
    void add(std::string key, Json value);

   private:
    struct Hash {
      using is_transparent = void;
      std::size_t operator()(std::string_view key) const { return std::hash<std::string_view>()(key); }
    };

    std::vector<std::pair<std::string, Json>> pairs_;
    std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> places_;  ///< empty of up to 32 keys
  };
  using Value = std::variant<std::nullptr_t, bool, double, std::int64_t, std::uint64_t, std::string,
                             std::vector<Json>, Members>;
  friend struct JsonText;
  Value value_ = nullptr;
};

}  // namespace stepwire::json
