#pragma once

#include <catch2/catch.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace stepwire::testing {

inline std::vector<std::string> list_in(const std::string& text) {
  std::vector<std::string> items;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ';');) items.push_back(item);
  return items;
}

inline std::string attribute_of(const std::string& tag, const std::string& name) {
  std::smatch found;
  return std::regex_search(tag, found, std::regex(" " + name + "=\"([^\"]*)\"")) ? found[1].str() : "";
}

/// Returns the value of an <animate> at a share of its time, by SVG 1.1 (19.2.9). Without keyTimes the values
/// are evenly spaced, and discrete ones hold until the next. The share must be one at which a smooth value is
/// given.
inline std::string value_at(const std::string& animate, double share) {
  const std::vector<std::string> values = list_in(attribute_of(animate, "values"));
  if (attribute_of(animate, "calcMode") != "discrete") {
    const double place = share * static_cast<double>(values.size() - 1);
    REQUIRE(std::abs(place - std::round(place)) < 1e-6);
    return values.at(static_cast<std::size_t>(std::round(place)));
  }
  const std::vector<std::string> times = list_in(attribute_of(animate, "keyTimes"));
  REQUIRE(times.size() == values.size());
  std::size_t last = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (std::stod(times[i]) <= share + 1e-6) last = i;
  return values[last];
}

/// Returns an animated picture as a viewer shows it at a share of its time: a picture without animations.
inline std::string frozen(const std::string& animated, double share) {
  std::string result;
  std::size_t owner = 0;  // where the last element that is no animation begins in the result
  for (std::size_t at = 0; at < animated.size();) {
    const std::size_t end = animated.find('>', at) + 1;
    const std::size_t open = animated.find('<', at);
    if (open == std::string::npos) break;
    const std::string tag = animated.substr(open, end - open);
    result += animated.substr(at, open - at);
    if (tag.starts_with("<animate ")) {
      const std::regex value("( " + attribute_of(tag, "attributeName") + "=\")[^\"]*\"");
      const std::string changed =
          std::regex_replace(result.substr(owner), value, "$01" + value_at(tag, share) + "\"");
      result = result.substr(0, owner) + changed;
    } else {
      if (tag[1] != '/') owner = result.size();
      result += tag;
    }
    at = end;
  }
  result = std::regex_replace(result, std::regex("\n+"), "\n");
  result = std::regex_replace(result, std::regex("\n</text>"), "</text>");
  return std::regex_replace(result, std::regex(">\n</(circle|line|path|polyline|rect)>"), "/>") + "\n";
}

}  // namespace stepwire::testing
