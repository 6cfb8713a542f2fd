#include "engine/base/hash/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <new>

namespace stepwire::hash {

struct Hash::State {
  XXH3_state_t* state = XXH3_createState();

  State() {
    if (!state) throw std::bad_alloc();
    XXH3_128bits_reset(state);
  }
  ~State() { XXH3_freeState(state); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

Hash::Hash() : state_(std::make_unique<State>()) {}
Hash::~Hash() = default;

Hash& Hash::add(std::string_view piece) {
  const std::uint64_t size = piece.size();
  XXH3_128bits_update(state_->state, &size, sizeof size);
  XXH3_128bits_update(state_->state, piece.data(), piece.size());
  return *this;
}

std::string Hash::text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->state);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_of(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace stepwire::hash
