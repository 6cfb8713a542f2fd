#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <list>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/driver/driver.h"

namespace stepwire::support {

/// Settings of a device as a driver gets them. Functions throw std::runtime_error with one sentence.
class Settings {
 public:
  Settings(const stepwire_setting* settings, std::size_t count) : all_(settings, settings + count) {}

  bool has(const char* key) const { return find(key) != nullptr; }
  std::string text(const char* key, const std::string& otherwise) const {
    const char* const value = find(key);
    return value ? value : otherwise;
  }
  std::string text(const char* key) const {
    if (const char* const value = find(key)) return value;
    throw std::runtime_error(std::string("the setting '") + key + "' is missing");
  }
  double number(const char* key, double otherwise) const { return scaled(key, otherwise, {{"", 1.0}}); }
  std::int64_t whole(const char* key, std::int64_t otherwise) const {
    constexpr double most = 1ll << 53;  // of exact ones
    const double value = number(key, static_cast<double>(otherwise));
    if (!(value >= -most && value <= most)) refuse(key, "is no whole number of at most 2^53");
    if (value != static_cast<double>(static_cast<std::int64_t>(value))) refuse(key, "is no whole number");
    return static_cast<std::int64_t>(value);
  }
  /// Returns a time [ns]: "2 ms".
  std::int64_t time(const char* key, double otherwise) const {
    constexpr double longest = 1e18;
    const double time = scaled(key, otherwise, {{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}});
    if (!(time >= 0.0 && time <= longest)) refuse(key, "is a time from 0 to 1e9 s");
    return static_cast<std::int64_t>(time);
  }
  /// Returns a length [m]: "30 cm".
  double length(const char* key, double otherwise) const {
    return scaled(key, otherwise, {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}});
  }
  bool truth(const char* key, bool otherwise) const {
    const std::string value = text(key, otherwise ? "true" : "false");
    if (value != "true" && value != "false") refuse(key, "is neither true nor false");
    return value == "true";
  }
  /// Returns the index of a word.
  std::size_t word(const char* key, const std::vector<std::string>& words) const {
    const std::string value = text(key, words.front());
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == value) return i;
    std::string all;
    for (const std::string& one : words) all += (all.empty() ? "" : ", ") + one;
    throw std::runtime_error(std::string("the setting '") + key + "' is one of: " + all);
  }
  [[noreturn]] static void refuse(const char* key, const char* what) {
    throw std::runtime_error(std::string("the setting '") + key + "' " + what);
  }

 private:
  struct Scale {
    const char* unit;
    double factor;
  };

  const char* find(const char* key) const {
    for (const stepwire_setting& one : all_)
      if (std::strcmp(one.key, key) == 0) return one.value;
    return nullptr;
  }
  double scaled(const char* key, double otherwise, const std::vector<Scale>& scales) const {
    const char* const value = find(key);
    if (!value) return otherwise;
    char* end = nullptr;
    const double number = std::strtod(value, &end);
    if (end == value || !std::isfinite(number)) refuse(key, "is no finite number");
    while (*end == ' ') ++end;
    for (const Scale& scale : scales)
      if (std::strcmp(end, scale.unit) == 0) return number * scale.factor;
    std::string units;
    for (const Scale& scale : scales) units += (units.empty() ? "" : ", ") + std::string(scale.unit);
    refuse(key,
           scales.size() > 1 ? ("needs a unit, one of " + units).c_str() : "takes a number without a unit");
  }

  std::vector<stepwire_setting> all_;
};

/// Table of channels that owns its texts.
class Channels {
 public:
  void add(const std::string& name, int direction, const char* kind, const std::string& unit, double least,
           double most, const std::string& doc) {
    const char* const text = texts_.emplace_back(name).c_str();
    const char* const of_unit = texts_.emplace_back(unit).c_str();
    table_.push_back({text, direction, kind, of_unit, least, most, texts_.emplace_back(doc).c_str()});
    counts_[direction] += 1;
  }
  /// Adds channels from a list of names with units: "force in N, button".
  void add_list(const std::string& list, int direction) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    for (std::size_t at = 0; at < list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      const auto [name, unit] = name_and_unit(list.substr(at, end - at));
      add(name, direction, "number", unit, -unlimited, unlimited, "");
      at = end + 1;
    }
  }
  /// Splits "force in N" or "force [N]" into "force" and "N".
  static std::pair<std::string, std::string> name_and_unit(std::string text) {
    const auto trimmed = [](const std::string& of) {
      const auto first = of.find_first_not_of(" \t\r\""), last = of.find_last_not_of(" \t\r\"");
      return first == std::string::npos ? std::string() : of.substr(first, last - first + 1);
    };
    text = trimmed(text);
    if (const auto in = text.find(" in "); in != std::string::npos)
      return {trimmed(text.substr(0, in)), trimmed(text.substr(in + 4))};
    const auto open = text.find('[');
    if (open == std::string::npos || text.back() != ']') return {text, ""};
    return {trimmed(text.substr(0, open)), text.substr(open + 1, text.size() - open - 2)};
  }

  const std::vector<stepwire_channel>& table() const { return table_; }
  std::size_t count(int direction) const { return counts_[direction]; }

 private:
  std::list<std::string> texts_;
  std::vector<stepwire_channel> table_;
  std::size_t counts_[2] = {0, 0};
};

}  // namespace stepwire::support
