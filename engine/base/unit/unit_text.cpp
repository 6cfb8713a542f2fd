#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/base/unit/decimal.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {
namespace {

constexpr std::size_t longest_word = 64;
constexpr std::size_t max_words = 10'000;  // bounds the cache for arbitrary input

/// Units of udunits2 that would turn a typing error into a valid unit: elementary charge, atomic mass, are,
/// barn and roentgen. The constant pi is refused as well.
constexpr std::array<std::string_view, 6> refused{"e", "u", "a", "b", "R", "pi"};

/// Units missing in udunits2, and mph and kph, which it reads as milliphot and kilophot.
constexpr std::array<std::pair<const char*, const char*>, 11> added{{{"deg", "degree"},
                                                                     {"rev", "revolution"},
                                                                     {"Nm", "N.m"},
                                                                     {"Wh", "W.h"},
                                                                     {"Ah", "A.h"},
                                                                     {"mph", "mile/hour"},
                                                                     {"kph", "km/hour"},
                                                                     {"gn", "9.80665 m/s2"},
                                                                     {"delta_degC", "K"},
                                                                     {"delta_degF", "0.5555555555555556 K"},
                                                                     {"temperature_K", "K"}}};

struct Free {
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using System = std::unique_ptr<ut_system, Free>;
using Parsed = std::unique_ptr<ut_unit, Free>;

System read_system() {
  ut_set_error_message_handler(ut_ignore);
  System system(ut_read_xml(nullptr));
  if (!system)
    throw std::runtime_error("the unit database of udunits2 cannot be read; is libudunits2-data installed?");
  for (const auto& [name, meaning] : added) {
    const Parsed unit(ut_parse(system.get(), meaning, UT_ASCII));
    ut_map_symbol_to_unit(name, UT_ASCII, unit.get());
  }
  return system;
}

/// Adds `power` of one base unit; the radian counts as an angle and has dimension 1.
void raise(Dimension& dimension, const ut_unit* base, int power) {
  constexpr std::array<std::string_view, 7> symbols{"m", "kg", "s", "A", "K", "mol", "cd"};
  const char* symbol = ut_get_symbol(base, UT_ASCII);
  const auto at = std::find(symbols.begin(), symbols.end(), symbol ? symbol : "");
  if (at != symbols.end()) dimension.exponents.at(static_cast<std::size_t>(at - symbols.begin())) += power;
  if (symbol && std::string_view(symbol) == "rad") dimension.angle += power;
}

ut_status visit_basic(const ut_unit* base, void* unit) {
  raise(static_cast<Unit*>(unit)->dimension, base, 1);
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* bases, const int* powers,
                        void* unit) {
  for (int i = 0; i < count; ++i) raise(static_cast<Unit*>(unit)->dimension, bases[i], powers[i]);
  return UT_SUCCESS;
}

ut_status visit(const ut_unit* parsed, Unit& unit);

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset, void* unit) {
  auto& result = *static_cast<Unit*>(unit);
  result.scale = as_published(scale);
  result.offset = result.scale * as_decimal(offset);
  return visit(underlying, result);
}

/// Timestamps and logarithms are not multiples of a base unit.
ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void*) {
  return UT_MEANINGLESS;
}
ut_status visit_logarithm(const ut_unit*, double, const ut_unit*, void*) {
  return UT_MEANINGLESS;
}

ut_status visit(const ut_unit* parsed, Unit& unit) {
  const ut_visitor visitor{visit_basic, visit_product, visit_galilean, visit_timestamp, visit_logarithm};
  return ut_accept_visitor(parsed, &visitor, &unit);
}

/// Sets the meaning of a unit. delta_degC is a difference of temperatures; degC is a temperature. So is
/// temperature_K, the unit of parameters inside of formulas.
void add_meaning(std::string_view word, Unit& unit) {
  if (word.starts_with("delta_deg"))
    unit.dimension.zeros = 0.0;
  else if (unit.offset != 0.0L || word == "temperature_K")
    unit.dimension.zeros = 1.0;
  if (word.ends_with("Hz") || word.ends_with("hertz")) unit.dimension.cycles = 1.0;
}

/// Marks a product of units with degC or delta_degC in it.
Dimension marked(Dimension product, const Dimension& a, const Dimension& b) {
  const bool has_kelvin = product.exponents[4] != 0.0 && !is_temperature(product);
  product.per_difference = product.per_difference || (has_kelvin && (a.zeros || b.zeros));
  return product;
}

/// Cache of looked-up words. The database of udunits2 is read on first use; the mutex is needed because
/// udunits2 is not thread-safe.
class Words {
 public:
  std::optional<Unit> find(const std::string& word) {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(word); known != known_.end()) return known->second;
    if (!system_) system_ = read_system();
    if (known_.size() >= max_words) known_.clear();
    return known_[word] = read(word);
  }

 private:
  std::optional<Unit> read(const std::string& word) const {
    const Parsed parsed(ut_parse(system_.get(), word.c_str(), UT_UTF8));
    Unit unit;
    if (!parsed || visit(parsed.get(), unit) != UT_SUCCESS) return std::nullopt;
    add_meaning(word, unit);
    const std::string letters = word.substr(0, word.find_last_not_of("0123456789") + 1);
    if (letters.size() < word.size())  // "degC2"
      if (const auto single = read(letters)) unit.dimension = marked(unit.dimension, single->dimension, {});
    return unit;
  }

  std::mutex mutex_;
  System system_;
  std::map<std::string, std::optional<Unit>> known_;
};

/// Returns the unit of a single word, with prefix and exponent: "mm", "lbf", "degC", "%", "m2". Returns
/// std::nullopt for other words. Thread-safe.
std::optional<Unit> named_unit(std::string_view word) {
  static Words words;
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  const auto letters = word.substr(0, word.find_last_not_of("0123456789") + 1);
  if (std::find(refused.begin(), refused.end(), letters) != refused.end()) return std::nullopt;
  if (letters.size() < word.size() && word[letters.size()] == '0') return std::nullopt;  // "m0" is a name
  return words.find(std::string(word));
}

constexpr std::size_t longest_unit = 200;
constexpr int deepest = 8;
constexpr double largest_exponent = 20.0;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// True for letters and all bytes beyond ASCII, since "µ", "°" and "Ω" are several bytes long.
bool starts_word(char c) {
  const char lower = static_cast<char>(c | 0x20);
  return (lower >= 'a' && lower <= 'z') || c == '_' || c == '%' ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

Unit raised(const Unit& unit, double exponent) {
  if (exponent == 1.0) return unit;
  return {std::pow(unit.scale, static_cast<long double>(exponent)), 0.0L,
          marked(power(unit.dimension, exponent), unit.dimension, {})};
}

bool usable(const Unit& unit) {
  return std::isfinite(unit.scale) && unit.scale > 0.0L;
}

/// True where the word continues at `at`, so that the unit before is only its start: "s" of "s.x" or of
/// "sin".
bool name_goes_on(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  if (starts_word(text[at]) || is_digit(text[at]) || text[at] == '(') return true;
  return text[at] == '.' && at + 1 < text.size() && starts_word(text[at + 1]);
}

using Taken = std::function<bool(std::string_view)>;

/// Parser of the longest prefix that is a unit; `end` is the end of the last complete unit.
class Reader {
 public:
  /// `taken` selects parsing inside an expression: no blanks, no "s-1" (a difference there), no partial
  /// names.
  explicit Reader(std::string_view text, const Taken* taken = nullptr) : text_(text), taken_(taken) {}

  std::optional<Unit> product(int depth) {
    auto result = at_one() ? one() : factor(depth, false);
    std::optional<Unit> complete;
    std::size_t complete_at = at_;
    while (result) {
      if (!taken_ || !name_goes_on(text_, at_)) {
        complete = result;
        complete_at = at_;
      }
      const char sign = operation();
      const auto next = sign ? factor(depth, true) : std::nullopt;
      result = next ? std::optional(joined(*result, sign, *next)) : std::nullopt;
    }
    at_ = complete_at;
    return complete;
  }

  std::size_t end() const { return at_; }

 private:
  static Unit joined(const Unit& a, char sign, const Unit& b) {
    const Dimension product = sign == '/' ? a.dimension / b.dimension : a.dimension * b.dimension;
    return {sign == '/' ? a.scale / b.scale : a.scale * b.scale, 0.0L,
            marked(product, a.dimension, b.dimension)};
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  /// True for a bare 1, which may start a unit as in "1/s"; a unit contains no other number.
  bool at_one() const { return peek() == '1' && (peek(1) == '/' || (!taken_ && text_ == "1")); }

  std::optional<Unit> one() {
    ++at_;
    return Unit{};
  }

  void skip_blanks() {
    while (!taken_ && peek() == ' ') ++at_;
  }

  char operation() {
    const std::size_t before = at_;
    skip_blanks();
    const char c = peek();
    if (c == '.' || c == '*' || c == '/') {
      ++at_;
      skip_blanks();
      return c;
    }
    return at_ > before ? ' ' : '\0';
  }

  std::optional<Unit> factor(int depth, bool later) {
    if (peek() == '(') return depth < deepest ? parenthesis(depth) : std::nullopt;
    const std::size_t first = at_;
    const std::string_view name = word();
    if (name.empty() || (later && is_taken(first))) return std::nullopt;
    const auto unit = named_unit(name);
    return unit ? with_exponent(*unit) : std::nullopt;
  }

  std::optional<Unit> parenthesis(int depth) {
    ++at_;
    skip_blanks();
    const auto result = product(depth + 1);
    skip_blanks();
    if (!result || peek() != ')') return std::nullopt;
    ++at_;
    return with_exponent(*result);
  }

  std::string_view word() {
    const std::size_t first = at_;
    if (!starts_word(peek())) return {};
    while (starts_word(peek()) || is_digit(peek())) ++at_;
    return text_.substr(first, at_ - first);
  }

  /// Parses the exponent of a unit: "m^2", "m^-0.5", "s-1".
  std::optional<Unit> with_exponent(const Unit& unit) {
    const bool hat = peek() == '^';
    if (!hat && (taken_ || peek() != '-')) return unit;
    double exponent = 0.0;
    const char* const first = text_.data() + at_ + (hat ? 1 : 0);
    auto [rest, error] =
        std::from_chars(first, text_.data() + text_.size(), exponent, std::chars_format::fixed);
    if (error != std::errc{} || exponent == 0.0 || !(std::abs(exponent) <= largest_exponent)) return unit;
    if (rest[-1] == '.') --rest;  // "m^2.s"
    at_ = static_cast<std::size_t>(rest - text_.data());
    return raised(unit, exponent);
  }

  /// True where the name that starts at `first`, with or without its dotted continuation, is taken.
  bool is_taken(std::size_t first) const {
    if (!taken_ || !*taken_) return false;
    std::size_t end = at_;
    if ((*taken_)(text_.substr(first, end - first))) return true;
    while (end < text_.size() && (text_[end] == '.' || starts_word(text_[end]) || is_digit(text_[end])))
      ++end;
    return (*taken_)(text_.substr(first, end - first));
  }

  std::string_view text_;
  const Taken* taken_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text.empty()) return Unit{};
  if (text.size() > longest_unit) return std::nullopt;
  Reader reader(text);
  const auto unit = reader.product(0);
  if (!unit || reader.end() != text.size() || !usable(*unit)) return std::nullopt;
  return unit;
}

std::size_t unit_prefix(std::string_view text, const Taken& taken) {
  Reader reader(text.substr(0, longest_unit), &taken);
  const auto unit = reader.product(0);
  return unit && usable(*unit) ? reader.end() : 0;
}

}  // namespace stepwire::unit
