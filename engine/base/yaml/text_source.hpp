#pragma once

#include <streambuf>
#include <string_view>

namespace stepwire::yaml {

/// Stream buffer over a text that bounds the memory of the YAML scanner. A scanner that searches the end of a
/// flow list accumulates tokens, each much larger than its character. The buffer counts the token characters
/// read since the last progress().
class TextSource : public std::streambuf {
 public:
  explicit TextSource(std::string_view text);

  /// Resets the count, after the parser has emitted an event.
  void progress() { signs_ = 0; }
  /// Thrown from a read after too many token characters without progress().
  struct TooFarAhead {};

 protected:
  std::streamsize xsgetn(char* to, std::streamsize count) override;

 private:
  std::size_t signs_ = 0;
};

}  // namespace stepwire::yaml
