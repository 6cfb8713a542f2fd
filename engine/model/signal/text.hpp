#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace stepwire {

namespace detail {

/// String literal as a template argument.
template <std::size_t n>
struct LiteralText {
  consteval LiteralText(const char (&literal)[n]) { std::copy_n(literal, n, text); }
  char text[n]{};
};

}  // namespace detail

#ifdef STEPWIRE_LONGEST_LIST
/// Text in a generated program: a view of a literal, since the program only steps.
class Text {
 public:
  Text() = default;
  Text(std::string_view text) : view_(text) {}
  Text(const char* text) : view_(text) {}
  template <detail::LiteralText text>
  static Text literal() {
    return Text(text.text);
  }

  std::string_view view() const { return view_; }
  operator std::string_view() const { return view_; }

 private:
  std::string_view view_;
};
#else

/// Text parameter, read only before a run. It has the size of a pointer.
class Text {
 public:
  Text() = default;
  Text(std::string_view text) : held_(text.empty() ? nullptr : new Owned(text)) {}
  Text(const char* text) : Text(std::string_view(text)) {}
  /// Makes a default value without heap memory: Text::literal<"time">().
  template <detail::LiteralText text>
  static Text literal() {
    static constexpr Held held{text.text, false};
    Text result;
    result.held_ = &held;
    return result;
  }

  Text(const Text& other) : held_(other.owns() ? new Owned(other.view()) : other.held_) {}
  Text(Text&& other) noexcept : held_(std::exchange(other.held_, nullptr)) {}
  Text& operator=(Text other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Text() {
    if (owns()) delete static_cast<const Owned*>(held_);
  }

  std::string_view view() const { return held_ ? held_->view : std::string_view(); }
  operator std::string_view() const { return view(); }

 private:
  struct Held {
    std::string_view view;
    bool owned;
  };
  struct Owned : Held {
    explicit Owned(std::string_view from) : Held{{}, true}, text(from) { view = text; }
    std::string text;
  };

  bool owns() const { return held_ && held_->owned; }

  const Held* held_ = nullptr;
};

#endif

}  // namespace stepwire
