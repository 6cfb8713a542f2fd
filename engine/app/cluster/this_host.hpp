#pragma once

#include <unistd.h>

#include <array>
#include <string>

namespace stepwire::cluster {

/// Returns the host name; an empty string if it is unavailable.
inline const std::string& this_host() {
  static const std::string name = [] {
    std::array<char, 256> text{};
    return std::string(::gethostname(text.data(), text.size() - 1) == 0 ? text.data() : "");
  }();
  return name;
}

}  // namespace stepwire::cluster
