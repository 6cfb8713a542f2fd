#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <regex>
#include <thread>

#include "tests/engine/app/cli/program.hpp"
#include "tests/engine/app/studio/raw_client.hpp"

namespace stepwire {

namespace {

using json::Json;

/// The program at work on a file, until the test ends it.
class RunningStudio {
 public:
  /// `port`: that of --port, which is absent where this is nullptr.
  explicit RunningStudio(const Scratch& folder, const char* port = nullptr) : out_(folder.path("out.txt")) {
    ::unlink(out_.c_str());
    child_ = ::fork();
    if (child_ == 0) begin(folder, port);
    for (int i = 0; i < 500 && !read_address(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ~RunningStudio() { end(SIGKILL); }
  RunningStudio(const RunningStudio&) = delete;
  RunningStudio& operator=(const RunningStudio&) = delete;

  const http::Key& key() const { return key_; }
  std::string printed() const { return content_of(out_); }
  /// Sends a signal and returns the exit status as in a shell, 128 + signal if a signal ended it.
  int end(int signal) {
    if (child_ <= 0) return -1;
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  [[noreturn]] void begin(const Scratch& folder, const char* port) const {
    ::setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1);
    ::dup2(::open(out_.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    const std::string file = folder.path("lag.yaml");
    ::execl(STEPWIRE_PROGRAM, "stepwire", "studio", file.c_str(), "--no-open", port ? "--port" : nullptr,
            port, nullptr);
    ::_exit(127);
  }
  bool read_address() {
    std::smatch match;
    const std::string text = printed();
    if (!std::regex_search(text, match, std::regex(R"(http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})\n)")))
      return false;
    key_ = {static_cast<std::uint16_t>(std::stoi(match[1])), match[2]};
    return true;
  }

  std::string out_;
  pid_t child_ = -1;
  http::Key key_;
};

Json edit(int version, int from, int to, const std::string& text) {
  const Json change = Json::object().set("from", from).set("to", to).set("text", text);
  return Json::object().set("file", 0).set("version", version).set("changes", Json::list({change}));
}

}  // namespace

TEST_CASE("the studio prints its address, and a signal ends it cleanly") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Scratch folder;
    folder.file("lag.yaml", lag_yaml);
    RunningStudio studio(folder);
    PageClient page(studio.key());
    REQUIRE(page.is_open());
    CHECK(page.call("edit", edit(0, 0, 0, "# draft\n")).find("result"));
    CHECK(studio.end(signal) == 0);
    CHECK_FALSE(page.receive());
    const std::string printed = studio.printed();
    CHECK(printed.find(studio.key().token) == printed.rfind(studio.key().token));  // once, in the address
    RunningStudio again(folder);
    PageClient later(again.key());
    CHECK(again.key().token != studio.key().token);
    const Json opened = later.call("open", Json::object().set("file", 0));
    CHECK(*opened.find("result")->find("draft")->as_text() == "# draft\n" + lag_yaml);
  }
}

TEST_CASE("a draft is there after kill -9 in the middle of typing") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  {
    RunningStudio studio(folder);
    PageClient page(studio.key());
    REQUIRE(page.is_open());
    for (int i = 0; i < 20; ++i) REQUIRE(page.call("edit", edit(i, i, i, "#")).find("result"));
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));  // a draft is kept within this time
    for (int i = 20; i < 25; ++i) page.call("edit", edit(i, i, i, "#"));
    CHECK(studio.end(SIGKILL) == 128 + SIGKILL);
  }
  RunningStudio studio(folder);
  PageClient page(studio.key());
  const Json opened = page.call("open", Json::object().set("file", 0));
  const std::string draft = *opened.find("result")->find("draft")->as_text();
  CHECK(draft.starts_with(std::string(20, '#')));
  CHECK(draft.ends_with(lag_yaml));
  CHECK(content_of(folder.path("lag.yaml")) == lag_yaml);
}

TEST_CASE("a file or a port that is not to be had is said in one line") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done missing = run_program(folder, {"studio", "none.yaml", "--no-open"});
  CHECK(missing.code == 3);
  CHECK(missing.err == "none.yaml: No such file or directory\n");
  RunningStudio studio(folder);
  const Done taken =
      run_program(folder, {"studio", "lag.yaml", "--no-open", "--port", std::to_string(studio.key().port)});
  CHECK(taken.code == 3);
  CHECK_THAT(taken.err, Catch::Contains("is taken on this machine; --port N names another one"));
}

TEST_CASE("a port that is none is refused in one sentence") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const char* port : {"99999", "-1", "-0", "80a", "65536"}) {
    const Done done = run_program(folder, {"studio", "lag.yaml", "--no-open", "--port", port});
    CHECK(done.code == 2);
    CHECK(done.err == std::string("--port ") + port +
                          ": must be a whole number from 0 to 65535, where 0 is any free port\n");
  }
}

TEST_CASE("port 0 is any free port, and the address names the one that serves") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const RunningStudio one(folder, "0"), other(folder, "0");
  CHECK(one.key().port > 0);
  CHECK(other.key().port != one.key().port);
  PageClient page(one.key());
  CHECK(page.is_open());
}

TEST_CASE("the timing of a loop needs --loop, and is checked before the studio begins") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done without = run_program(folder, {"studio", "lag.yaml", "--no-open", "--rate", "500"});
  CHECK(without.code == 2);
  CHECK_THAT(without.err, Catch::Contains("--rate requires --loop"));
  const Done wrong = run_program(folder, {"studio", "lag.yaml", "--no-open", "--loop", "--rate", "0.1"});
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, Catch::Contains("must be from 1 Hz to 1 MHz"));
}

}  // namespace stepwire
