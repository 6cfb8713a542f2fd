#pragma once

#include <linux/input.h>

#include <array>
#include <climits>
#include <cstddef>
#include <optional>
#include <string>

namespace stepwire::evdev {

/// Set of codes of the kernel, such as the buttons that are down.
template <std::size_t count>
class Codes {
 public:
  bool has(std::size_t code) const { return (words_[code / bits] >> (code % bits) & 1ul) != 0; }
  bool has_any(std::size_t first, std::size_t last) const {
    for (std::size_t code = first; code <= last; ++code)
      if (has(code)) return true;
    return false;
  }
  void set(std::size_t code, bool on) {
    words_[code / bits] &= ~(1ul << code % bits);
    words_[code / bits] |= static_cast<unsigned long>(on) << code % bits;
  }
  void* data() { return words_.data(); }
  static constexpr std::size_t bytes() { return sizeof words_; }

 private:
  static constexpr std::size_t bits = sizeof(unsigned long) * CHAR_BIT;
  std::array<unsigned long, (count + bits - 1) / bits> words_{};
};

using Keys = Codes<KEY_CNT>;
using Axes = Codes<ABS_CNT>;

/// Open file of an input device, with the axes and buttons that the device has.
class InputFile {
 public:
  /// Opens a file. Returns std::nullopt with errno where that fails, and where it is no input device.
  static std::optional<InputFile> open(const std::string& path);
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;
  ~InputFile();

  const std::string& path() const { return path_; }
  const std::string& name() const { return name_; }
  const Keys& keys() const { return keys_; }
  const Axes& axes() const { return axes_; }

  /// Fetches the range of an axis and its present value. Returns false where the device does not answer.
  bool fetch(std::size_t axis, input_absinfo& info) const noexcept;
  /// Fetches the buttons that are down.
  bool fetch(Keys& down) const noexcept;
  /// Reads at most `count` events. Returns their number, 0 for none, std::nullopt once the device fails.
  std::optional<std::size_t> read(input_event* events, std::size_t count) const noexcept;

 private:
  InputFile(std::string path, int file) : path_(std::move(path)), file_(file) {}
  bool describe();

  std::string path_, name_;
  int file_;  ///< -1 once moved
  Keys keys_;
  Axes axes_;
};

}  // namespace stepwire::evdev
