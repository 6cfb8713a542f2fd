#pragma once

#include <string>
#include <string_view>

#include "engine/model/signal/text.hpp"

namespace stepwire {

/// File path as a parameter. Generated code constructs blocks at each step and compiles their headers, so
/// std::filesystem::path would be too slow for both.
class FilePath : public Text {
 public:
  using Text::Text;
  std::string string() const { return std::string(view()); }
};

}  // namespace stepwire
