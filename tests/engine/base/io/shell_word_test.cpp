#include <catch2/catch.hpp>

#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::io {

TEST_CASE("a shell reads every text as the one word that it was") {
  for (const std::string text : {"plain/path-1.yaml", "", "my rig", "it's", "$(id) `id` $HOME", "a;b|c&d>e",
                                 "*?[x]", "-n\nline", "\\", "ä\""}) {
    const subprocess::ProcessResult said =
        subprocess::run_process({.command = {"sh", "-c", "printf '%s' " + text::shell_word(text)}});
    CHECK(said.output == text);
  }
  CHECK(text::shell_word("out/rig") == "out/rig");
}

}  // namespace stepwire::io
