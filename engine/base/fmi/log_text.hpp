#pragma once

#include <cstddef>
#include <string>

namespace stepwire::fmi {

/// Last fault message that a unit has logged. Storing one does not allocate.
class LogText {
 public:
  void take(const char* text);
  void clear() { text_[0] = '\0'; }
  bool empty() const { return text_[0] == '\0'; }
  std::string text() const { return text_; }

 private:
  static constexpr std::size_t room = 400;
  char text_[room] = "";
};

}  // namespace stepwire::fmi
