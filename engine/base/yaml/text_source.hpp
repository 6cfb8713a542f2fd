#pragma once

#include <streambuf>
#include <string_view>

namespace stepwire::yaml {

/// Hands a text to a stream reader without a copy, and counts what it takes to keep the reader from running
/// ahead: a scanner that must see the end of a flow list first piles up tokens, each many times larger than
/// its character.
class TextSource : public std::streambuf {
 public:
  explicit TextSource(std::string_view text);

  /// The reader has made something of what it took.
  void progress() { signs_ = 0; }
  /// Thrown out of a read when the reader took too much without making anything of it.
  struct TooFarAhead {};

 protected:
  std::streamsize xsgetn(char* to, std::streamsize count) override;

 private:
  std::size_t signs_ = 0;
};

}  // namespace stepwire::yaml
