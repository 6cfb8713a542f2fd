#include "engine/base/fmi/log_text.hpp"

namespace stepwire::fmi {

void LogText::take(const char* text) {
  std::size_t length = 0;
  for (; text && text[length] && length + 1 < room; ++length) {
    const auto byte = static_cast<unsigned char>(text[length]);
    text_[length] = byte < 0x20 || byte == 0x7f ? ' ' : text[length];
  }
  while (length > 0 && text_[length - 1] == ' ') --length;
  text_[length] = '\0';
}

}  // namespace stepwire::fmi
