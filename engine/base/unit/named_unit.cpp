#include "engine/base/unit/named_unit.hpp"

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "engine/base/unit/decimal.hpp"

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
    return unit;
  }

  std::mutex mutex_;
  System system_;
  std::map<std::string, std::optional<Unit>> known_;
};

}  // namespace

std::optional<Unit> named_unit(std::string_view word) {
  static Words words;
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  const auto letters = word.substr(0, word.find_last_not_of("0123456789") + 1);
  if (std::find(refused.begin(), refused.end(), letters) != refused.end()) return std::nullopt;
  if (letters.size() < word.size() && word[letters.size()] == '0') return std::nullopt;  // "m0" is a name
  return words.find(std::string(word));
}

}  // namespace stepwire::unit
