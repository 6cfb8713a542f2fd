#include "engine/base/hash/sha256.hpp"

#include <sha256.h>

#include <cstdint>

namespace stepwire::hash {

std::string sha256_of(std::string_view text) {
  SHA256_CTX context;
  SHA256_Init(&context);
  SHA256_Update(&context, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  std::string digits(SHA256_DIGEST_STRING_LENGTH, '\0');
  SHA256_End(&context, digits.data());
  digits.pop_back();
  return digits;
}

}  // namespace stepwire::hash
