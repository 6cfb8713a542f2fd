#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace stepwire::hash {

/// SHA-256 of a sequence of bytes (FIPS 180-4). No two texts of one hash are known, so it identifies
/// content from elsewhere. Pieces are joined: "ab", "c" and "a", "bc" have the same hash.
class Sha256 {
 public:
  Sha256& add(std::string_view piece);
  /// Returns 64 hexadecimal digits. The object is used up.
  std::string text();

 private:
  void add_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> rest_{};  ///< bytes of an incomplete block
  std::uint64_t size_ = 0;                ///< [bytes] added
};

/// Returns the SHA-256 of one text, as the program sha256sum prints it.
std::string sha256_of(std::string_view text);

}  // namespace stepwire::hash
