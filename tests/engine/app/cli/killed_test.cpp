// A program that is killed leaves no process, and the next one removes the folders of it.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/engine/app/cli/processes.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace {

/// A call whose compiler or gnuplot has begun further processes, and hangs with a file in its folder.
Call with_hanging(const Scratch& folder, const std::string& name, const std::string& before) {
  std::filesystem::create_directories(folder.path("bin"));
  std::filesystem::create_directories(folder.path("tmp"));
  const std::string script =
      folder.file("bin/" + name, "#!/bin/sh\n[ \"$1\" = --version ] && { echo fake 1; exit 0; }\n" + before +
                                     "touch \"$TMPDIR/piece.s\"\n(sleep 300 & sleep 300) &\ntouch " +
                                     folder.path("hangs") + "\nwait\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  Call call;
  call.arguments = {"run",   "lag.yaml", "--engine", name == "c++" ? "compiled" : "interpreted",
                    "--out", "out"};
  call.environment["PATH"] = folder.path("bin") + ":/usr/bin:/bin";
  call.environment["CXX"] = folder.path("bin/c++");
  call.environment["STEPWIRE_CACHE"] = folder.path("cache");
  call.environment["TMPDIR"] = folder.path("tmp");
  return call;
}

}  // namespace

TEST_CASE("a program that is killed while it compiles or draws leaves no process and no folder") {
  for (const std::string name : {"c++", "gnuplot"})
    for (const std::string before : {"", "trap '' TERM INT HUP\n"}) {
      const Scratch folder;
      folder.file("lag.yaml", lag_yaml);
      Call call = with_hanging(folder, name, before);
      call.interrupt_when = folder.path("hangs");
      call.signals = {SIGKILL};
      CHECK(run_program(folder, call).code == 128 + SIGKILL);
      INFO(name << " " << before);
      CHECK(processes_in(folder.path("")) == 0);

      Call next{{"check", "lag.yaml"}, {{"TMPDIR", folder.path("tmp")}}};
      CHECK(run_program(folder, next).code == 0);
      CHECK(std::filesystem::is_empty(folder.path("tmp")));
    }
}
