#pragma once

#include <string>
#include <string_view>

#include "engine/model/signal/text.hpp"

namespace stepwire {

/// The path of a file, as a parameter. Generated code makes a block anew at each step, and the headers of
/// blocks are what its compiler reads: std::filesystem::path would cost both dearly.
class FilePath : public Text {
 public:
  using Text::Text;
  std::string string() const { return std::string(view()); }
};

}  // namespace stepwire
