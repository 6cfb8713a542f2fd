#include "engine/app/studio/live/mechanisms.hpp"

#include "engine/app/studio/live/pointer.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"

namespace stepwire::live {

namespace {

json::Json mechanisms(const std::string& name) {
  diagram::Loader loader(library());
  LoadedRun run(load_for_page(loader, STEPWIRE_SOURCE_DIR "/diagrams/" + name + ".yaml"), simulated());
  json::Json found = *mechanisms_of(run).find("mechanisms");
  for (const json::Json& mechanism : found.items())
    for (const json::Json& element : mechanism.find("elements")->items())
      for (const json::Json& point : element.find("points")->items())
        for (const json::Json& coordinate : point.items())
          if (coordinate.as_text()) CHECK_NOTHROW(run.find(*coordinate.as_text()));
  return found;
}

std::size_t count_of(const json::Json& mechanism, const std::string& kind) {
  std::size_t count = 0;
  for (const json::Json& element : mechanism.find("elements")->items())
    count += *element.find("kind")->as_text() == kind ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("a mechanism has numbers for what stands still and signals for what moves") {
  const json::Json drawn = mechanisms("thesis/fig21-platform-3d");
  REQUIRE(drawn.items().size() == 1);
  CHECK(*drawn.items()[0].find("dimensions")->as_number() == 3.0);
  CHECK(count_of(drawn.items()[0], "damper") == 3);
  CHECK(drawn.text().find("rig.position.3") != std::string::npos);
}

TEST_CASE("a linkage that no figure draws is a mechanism by its block") {
  const json::Json found = mechanisms("thesis/fig22-force-in-space");
  REQUIRE(found.items().size() == 1);
  CHECK(count_of(found.items()[0], "damper") == 3);
  CHECK(count_of(found.items()[0], "end_effector") == 1);
  CHECK(mechanisms("examples/01-first-diagram").items().empty());
}

}  // namespace stepwire::live
