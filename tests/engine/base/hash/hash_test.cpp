#include "engine/base/hash/hash.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace stepwire::hash {

TEST_CASE("A hash is XXH3 of 128 bits") {
  // From the test vectors of xxHash 0.8: XXH128 of nothing, seed 0.
  CHECK(hash_of("") == "99aa06d3014798d86001c324468d497f");
}

TEST_CASE("Where a piece ends counts, and so does every byte") {
  CHECK(Hash().add("ab").add("c").text() != Hash().add("a").add("bc").text());
  CHECK(Hash().add("ab").add("c").text() == Hash().add("ab").add("c").text());
  std::set<std::string> seen;
  std::string text(1000, 'x');
  for (char& c : text) {
    c = 'y';
    seen.insert(hash_of(text));
  }
  CHECK(seen.size() == text.size());
}

}  // namespace stepwire::hash
