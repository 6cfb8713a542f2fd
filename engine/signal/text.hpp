#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace stepwire {

/// Text that a block is given and reads before a run only: a parameter. It takes no more room in the block
/// than a pointer.
class Text {
 public:
  Text() = default;
  Text(std::string_view text) : text_(text.empty() ? nullptr : std::make_unique<std::string>(text)) {}
  Text(const char* text) : Text(std::string_view(text)) {}
  Text(const Text& other) : Text(other.view()) {}
  Text(Text&&) noexcept = default;
  Text& operator=(const Text& other) { return *this = Text(other); }
  Text& operator=(Text&&) noexcept = default;
  ~Text() = default;

  std::string_view view() const { return text_ ? std::string_view(*text_) : std::string_view(); }
  operator std::string_view() const { return view(); }

 private:
  std::unique_ptr<std::string> text_;
};

}  // namespace stepwire
