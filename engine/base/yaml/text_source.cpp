#include "engine/base/yaml/text_source.hpp"

#include <algorithm>

namespace stepwire::yaml {
namespace {

// Most characters that can make a token between two events. A flow list of about this many numbers is
// readable; its tokens take less than 100 MB.
constexpr std::size_t max_signs = 250'000;

bool makes_token(char c) {
  return c == ',' || c == '[' || c == '{' || c == ']' || c == '}' || c == ':' || c == '?' || c == '-' ||
         c == '&' || c == '*' || c == '!' || c == '"' || c == '\'';
}

}  // namespace

TextSource::TextSource(std::string_view text) {
  char* begin = const_cast<char*>(text.data());  // required by std::streambuf, which does not write here
  setg(begin, begin, begin + text.size());
}

std::streamsize TextSource::xsgetn(char* to, std::streamsize count) {
  const std::streamsize taken = std::streambuf::xsgetn(to, count);
  signs_ += static_cast<std::size_t>(std::count_if(to, to + taken, makes_token));
  if (signs_ > max_signs) throw TooFarAhead{};
  return taken;
}

}  // namespace stepwire::yaml
