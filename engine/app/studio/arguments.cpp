#include "engine/app/studio/arguments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

void Arguments::refuse(const std::string& name, const std::string& kind) {
  throw Fault(fmt::format("'{}' of this call is missing or is no {}", name, kind));
}

const Json& Arguments::any(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found) refuse(name, "value");
  return *found;
}

int Arguments::whole(const std::string& name) const {
  const Json* found = message_.find(name);
  const auto number = found ? found->as_number() : std::nullopt;
  const bool fits = number && *number >= 0 && *number <= std::numeric_limits<int>::max();
  if (!fits || std::floor(*number) != *number) refuse(name, "whole number");
  return static_cast<int>(*number);
}

std::string Arguments::text(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->as_text()) refuse(name, "text");
  return *found->as_text();
}

bool Arguments::flag(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->as_flag()) refuse(name, "true or false");
  return *found->as_flag();
}

std::span<const Json> Arguments::items(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->is_list()) refuse(name, "list");
  return found->items();
}

std::vector<std::string> Arguments::texts(const std::string& name) const {
  std::vector<std::string> words;
  for (const Json& item : items(name)) {
    if (!item.as_text()) refuse(name, "list of texts");
    words.push_back(*item.as_text());
  }
  return words;
}

}  // namespace stepwire::studio
