#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace stepwire::hash {

/// A hash of 128 bits (XXH3) of several pieces, by which what was made of them is found again or known to be
/// whole. It keeps nobody from making another text of the same hash on purpose.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  /// Adds a piece. Where it ends counts, too: "ab" and "c" are not "a" and "bc".
  Hash& add(std::string_view piece);
  /// 32 hexadecimal digits.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of one text.
std::string hash_of(std::string_view text);

}  // namespace stepwire::hash
