#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace stepwire::hash {

/// A 128-bit hash (XXH3) of several pieces; it identifies cached results and detects damage. It is not
/// cryptographic: collisions can be constructed on purpose.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  /// Adds a piece. The boundaries of pieces count: "ab", "c" and "a", "bc" have different hashes.
  Hash& add(std::string_view piece);
  /// Returns 32 hexadecimal digits.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the hash of one text.
std::string hash_of(std::string_view text);

}  // namespace stepwire::hash
