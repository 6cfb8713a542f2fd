#include "engine/base/io/resources.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::io {

namespace {

/// $STEPWIRE_HOME for as long as a test lasts.
struct Home {
  explicit Home(const std::string& folder) { ::setenv("STEPWIRE_HOME", folder.c_str(), 1); }
  ~Home() { ::unsetenv("STEPWIRE_HOME"); }
};

}  // namespace

TEST_CASE("what comes with the program is found beside it, through links") {
  CHECK(std::filesystem::exists(resource("headers") + "/engine/model/block/block.hpp"));
  CHECK(std::filesystem::exists(resource("diagrams") + "/thesis"));
  CHECK(resource("drawing") == std::filesystem::canonical(resource("headers") + "/engine/view/drawing"));
}

TEST_CASE("STEPWIRE_HOME names another place, or the prefix above it, and no other is looked at then") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("here/drawing"));
  std::filesystem::create_directories(scratch.path("prefix/share/stepwire/drawing"));
  {
    const Home home(scratch.path("here"));
    CHECK(resource("drawing") == std::filesystem::canonical(scratch.path("here/drawing")));
    CHECK(find_resource("headers").empty());
    CHECK_THROWS_AS(resource("headers"), EnvironmentError);
    CHECK_THROWS_WITH(resource("headers"), Catch::Contains(scratch.path("here/headers")));
    CHECK_THROWS_WITH(resource("headers"), Catch::Contains("the Debian package libstepwire-dev has it"));
    CHECK_THROWS_WITH(resource("mpi"), Catch::Contains(scratch.path("here/mpi")) &&
                                           Catch::Contains("'./stepwire setup mpi' in a checkout builds it"));
  }
  const Home home(scratch.path("prefix"));
  CHECK(resource("drawing") == std::filesystem::canonical(scratch.path("prefix/share/stepwire/drawing")));
}

}  // namespace stepwire::io
