#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::codegen {

namespace {

/// Makes a folder of foreign blocks: yard/NAME.hpp, which includes "yard/law.hpp".
std::string yard(const Scratch& folder, const std::string& in, const std::string& name,
                 const std::string& law) {
  std::filesystem::create_directories(folder.path(in + "/yard"));
  folder.file(in + "/yard/law.hpp", law);
  return folder.file(in + "/yard/" + name + ".hpp", "#include \"yard/law.hpp\"\n");
}

}  // namespace

TEST_CASE("two folders of blocks that mean different files by one include cannot be in one program") {
  const Scratch folder;
  const std::string a = yard(folder, "one", "a", "// 1\n"), b = yard(folder, "two", "b", "// 2\n");
  CHECK(with_included({a}).all.size() == 2);
  CHECK(with_included({b}).all.size() == 2);
  CHECK_THROWS_AS(with_included({a, b}), io::EnvironmentError);
}

}  // namespace stepwire::codegen
