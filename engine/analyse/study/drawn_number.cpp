#include "engine/analyse/study/drawn_number.hpp"

namespace stepwire::study {

namespace {

constexpr std::uint64_t most = 1'000'000'000;

}  // namespace

std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from) {
  std::uint64_t hash = 0;
  for (const std::uint64_t number : from) {  // SplitMix64 (Steele, Lea and Flood 2014) of each sum
    hash += number + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return hash % most;
}

}  // namespace stepwire::study
