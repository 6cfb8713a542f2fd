#include <catch2/catch.hpp>

#include "engine/model/diagram/flatten.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

TEST_CASE("every block is the same after it was written into a flattened file") {
  for (const BlockType* type : library().types())
    for (const Wiring& wiring : wirings_of(*type)) {
      INFO(wiring.text);
      const auto plan = plan_of(wiring);
      if (!plan) continue;
      const std::string text = diagram::flattened_text(plan->diagram);
      INFO(text);
      const auto flat = plan_of({text});
      REQUIRE(flat);
      CHECK(diagram::flattened_text(flat->diagram) == text);
      CHECK(diagram::diagram_hash(flat->diagram) == diagram::diagram_hash(plan->diagram));
      run::Executor one(*plan), other(*flat);
      while (one.tick() < 10 && one.healthy()) {
        one.evaluate();
        other.evaluate();
        CHECK(same_bits(numbers_of(one), numbers_of(other)));
        one.advance();
        other.advance();
      }
    }
}
