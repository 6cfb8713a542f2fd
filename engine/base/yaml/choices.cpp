#include "engine/base/yaml/choices.hpp"

#include <string_view>

namespace stepwire::yaml {

std::vector<std::string> choice_groups(const Key& key) {
  std::vector<std::string> choices;
  constexpr std::string_view both = " and ";
  for (std::size_t at = 0; !key.choice.empty() && at != std::string::npos;) {
    const std::size_t end = key.choice.find(both, at);
    choices.push_back(key.choice.substr(at, end == std::string::npos ? end : end - at));
    at = end == std::string::npos ? end : end + both.size();
  }
  return choices;
}

}  // namespace stepwire::yaml
