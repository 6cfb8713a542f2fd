#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/app/language/language_server.hpp"

namespace stepwire::language {

namespace {

/// A server with three messages, and whether each is still held.
struct Asked {
  Asked() {
    for (const std::string id : {"1", "2", "3"}) {
      const auto held = std::make_shared<std::string>(id);
      kept.push_back(held);
      server.post(R"({"jsonrpc":"2.0","id":)" + id + R"(,"method":"initialize","params":{}})", held);
    }
  }
  std::vector<bool> held() const {
    std::vector<bool> all;
    for (const auto& one : kept) all.push_back(!one.expired());
    return all;
  }

  Registry registry = blocks();
  std::vector<std::weak_ptr<std::string>> kept;
  std::vector<std::vector<bool>> held_at_answer;
  LanguageServer server{registry, [this](const std::string&) { held_at_answer.push_back(held()); }};
};

}  // namespace

TEST_CASE("a message of an editor is held until it has been answered, and no longer") {
  Asked asked;
  asked.server.close();
  asked.server.run();
  CHECK(asked.held_at_answer ==
        std::vector<std::vector<bool>>{{true, true, true}, {false, true, true}, {false, false, true}});
  CHECK(asked.held() == std::vector<bool>{false, false, false});
}

TEST_CASE("a language server that is abandoned drops the messages that wait") {
  Asked asked;
  asked.server.abandon();
  CHECK(asked.held() == std::vector<bool>{false, false, false});
  CHECK_FALSE(asked.server.run());
  CHECK(asked.held_at_answer.empty());
}

}  // namespace stepwire::language
