// Where generated code finds the struct of a block.
#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/model/block/declare.hpp"
#include "tests/engine/base/table/scratch.hpp"

using stepwire::detail::header_of;

TEST_CASE("a block of the library has the header of the name beside its source, from the root") {
  CHECK(header_of("blocks/math/gain.cpp", "", "stepwire::Gain") == "blocks/math/gain.hpp");
  CHECK(header_of("tests/engine/gain.cpp", "", "stepwire::Gain").empty());
}

TEST_CASE("another block has the header that is named, its own source, or one beside it") {
  const Scratch folder;
  std::filesystem::create_directories(folder.path("source"));
  std::filesystem::create_directories(folder.path("include"));
  const std::string source = folder.file("source/drag.cpp", "");
  CHECK(header_of(source, "", "yard::Drag").empty());
  folder.file("include/drag.hpp", "");
  const std::string elsewhere = std::filesystem::canonical(folder.path("include/drag.hpp")).string();
  CHECK(header_of(source, "../include/drag.hpp", "yard::Drag") == elsewhere);
  CHECK(header_of(elsewhere, "", "yard::Drag") == elsewhere);
  folder.file("source/drag.h", "");
  CHECK(header_of(source, "", "yard::Drag") == std::filesystem::canonical(folder.path("source/drag.h")));
}

TEST_CASE("a struct that other sources cannot name has no header") {
  CHECK(header_of("blocks/math/gain.cpp", "", "stepwire::{anonymous}::Gain").empty());
  CHECK(header_of("blocks/math/gain.cpp", "", "(anonymous namespace)::Gain").empty());
  CHECK(header_of("blocks/math/gain.cpp", "", "make(int)::Gain").empty());
}
