#include "engine/table/cache.hpp"

#include <cstdlib>

namespace stepwire {

std::string cache_folder() {
  const auto variable = [](const char* name) -> std::string {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (!variable("STEPWIRE_CACHE").empty()) return variable("STEPWIRE_CACHE");
  if (!variable("XDG_CACHE_HOME").empty()) return variable("XDG_CACHE_HOME") + "/stepwire";
  return variable("HOME") + "/.cache/stepwire";
}

std::uint64_t hash_of(const std::string& text, std::uint64_t hash) {
  for (unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

}  // namespace stepwire
