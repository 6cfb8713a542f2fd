#include "engine/view/plot/figure_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/names.hpp"
#include "engine/analyse/query/number.hpp"

namespace stepwire {

void KeyReading::fault(Mark mark, const std::string& key, const std::string& message) const {
  faults.add({{names.file, mark}, "figure." + key, message, {}});
}

std::string KeyReading::text(const Node& node, const std::string& key) const {
  return read_text(node, names, "figure." + key, faults);
}

std::optional<std::size_t> KeyReading::word(const Node& node, const FigureKey& key) const {
  const auto found = std::ranges::find(key.words, node.text);
  if (node.is_scalar() && found != key.words.end())
    return static_cast<std::size_t>(found - key.words.begin());
  fault(node.mark, key.name,
        fmt::format("'{}' is not allowed; it is one of {}", node.text, fmt::join(key.words, ", ")));
  return std::nullopt;
}

std::optional<int> KeyReading::whole(const Node& node, const FigureKey& key) const {
  const auto number = read_number(node, names, "figure." + key.name, faults);
  if (!number) return std::nullopt;
  if (number->value >= key.low && number->value <= key.high && number->value == std::floor(number->value))
    return static_cast<int>(number->value);
  fault(node.mark, key.name,
        fmt::format("{} is not allowed; it must be a whole number from {} to {}", number->text, key.low,
                    key.high));
  return std::nullopt;
}

}  // namespace stepwire
