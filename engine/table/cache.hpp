#pragma once

#include <cstdint>
#include <string>

namespace stepwire {

/// Where results are kept that take long to make and follow from their input alone: $STEPWIRE_CACHE, else
/// $XDG_CACHE_HOME/stepwire, else ~/.cache/stepwire. It need not be there.
std::string cache_folder();

/// Of a text, by which a kept result is found again (FNV-1a); `hash` is that of what went before.
std::uint64_t hash_of(const std::string& text, std::uint64_t hash = 0xcbf29ce484222325u);

}  // namespace stepwire
