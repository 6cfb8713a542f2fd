// Quiet calls, and colours.
#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
using Catch::StartsWith;

namespace {

constexpr char escape = '\x1b';

/// False in a system without /dev/pts.
bool has_pseudo_terminals() {
  const int end = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (end < 0) return false;
  const bool opens = ::grantpt(end) == 0 && ::unlockpt(end) == 0;
  const char* const name = opens ? ::ptsname(end) : nullptr;
  const bool exists = name && ::access(name, R_OK | W_OK) == 0;
  ::close(end);
  return exists;
}

Done run_with(const Scratch& folder, std::vector<std::string> arguments,
              std::map<std::string, std::optional<std::string>> environment = {}) {
  Call call;
  call.arguments = std::move(arguments);
  call.environment = std::move(environment);
  return run_program(folder, call);
}

}  // namespace

TEST_CASE("a quiet call prints nothing where all is well, before the verb and behind it") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const std::vector<std::string>& call :
       std::vector<std::vector<std::string>>{{"run", "lag.yaml", "--quiet", "--out", "out"},
                                             {"--quiet", "run", "lag.yaml"},
                                             {"check", "lag.yaml", "--quiet"},
                                             {"verify", "out", "--quiet"}}) {
    const Done done = run_program(folder, call);
    CHECK(done.code == 0);
    CHECK(done.out.empty());
    CHECK(done.err.empty());
  }
}

TEST_CASE("a quiet call prints claims that fail, errors, and the data that it is for") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml + "  - {that: it is two, final: lag, equals: 2, within: 1 %}\n");
  Done done = run_program(folder, {"run", "lag.yaml", "--quiet"});
  CHECK(done.code == 1);
  REQUIRE(lines_of(done.out).size() == 2);
  CHECK_THAT(lines_of(done.out)[1], StartsWith("  FAIL it is two"));
  done = run_program(folder, {"run", "none.yaml", "--quiet"});
  CHECK_THAT(done.err, Contains("none.yaml"));
  CHECK_THAT(run_program(folder, {"check", "lag.yaml", "--quiet", "--json"}).out, Contains("\"claims\""));
  CHECK_THAT(run_program(folder, {"blocks", "Mass", "--quiet"}).out, Contains("Mass"));
}

TEST_CASE("what goes into a file or a pipe has no colours, unless the call says always") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("wrong.yaml", lag_yaml + "recrod: [lag]\n");
  CHECK(run_program(folder, {"run", "lag.yaml"}).out.find(escape) == std::string::npos);
  const Done done = run_with(folder, {"run", "lag.yaml", "--color", "always"}, {{"NO_COLOR", "1"}});
  CHECK_THAT(done.out, Contains("  \x1b[32mok   \x1b[0m"));
  CHECK_THAT(run_with(folder, {"--color", "always", "check", "wrong.yaml"}).err,
             StartsWith("\x1b[1mwrong.yaml:") && Contains(":\x1b[0m "));
}

TEST_CASE("a terminal has colours, but with NO_COLOR, a dumb one and --color never") {
  if (!has_pseudo_terminals()) {
    WARN("there are no pseudo-terminals here (/dev/pts); no colours of a terminal were looked at");
    return;
  }
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const auto on_terminal = [&](const std::string& before, const std::string& behind) {
    const std::string call = before + " '" STEPWIRE_PROGRAM "' check none.yaml " + behind + " 2>&1";
    Call script;
    folder.file("call.sh", "cd " + folder.path("") + "\nexec script -qec \"" + call + "\" /dev/null >seen\n");
    const int code = std::system(("sh " + folder.path("call.sh")).c_str());
    CHECK(WEXITSTATUS(code) == 2);
    return content_of(folder.path("seen"));
  };
  folder.file("none.yaml", "stepwire: 1\nblocks: 3\n");
  CHECK_THAT(on_terminal("TERM=xterm", ""), Contains("\x1b[1mnone.yaml:2:9:\x1b[0m "));
  CHECK(on_terminal("TERM=xterm NO_COLOR=1", "").find(escape) == std::string::npos);
  CHECK(on_terminal("TERM=dumb", "").find(escape) == std::string::npos);
  CHECK(on_terminal("TERM=xterm", "--color never").find(escape) == std::string::npos);
}
