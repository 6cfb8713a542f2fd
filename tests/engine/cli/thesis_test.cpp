#include <catch2/catch.hpp>
#include <regex>

#include "tests/engine/cli/program.hpp"

using Catch::Contains;

TEST_CASE("thesis --only makes the figures that are asked for, and a page whose links are there") {
  const Scratch folder;
  const Done done = run_program(folder, {"thesis", "--only", "fig15,fig31", "--out", "page"});
  INFO(done.err);
  CHECK(done.code == 0);
  const std::string page = content_of(folder.path("page/index.html"));
  const std::regex link("(?:href|src|data)=\"([^\"#:]+)\"");
  int links = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), link), none; match != none; ++match, ++links) {
    const std::string target = (*match)[1];
    INFO(target);
    CHECK(std::filesystem::exists(folder.path("page/" + target)));
  }
  CHECK(links >= 4);
  std::vector<std::string> made;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("page")))
    if (entry.is_directory()) made.push_back(entry.path().filename().string());
  std::sort(made.begin(), made.end());
  REQUIRE(made.size() == 2);
  CHECK_THAT(made[0], Catch::StartsWith("fig15"));
  CHECK_THAT(made[1], Catch::StartsWith("fig31"));
  for (const std::string name : {"signals.csv", "signals.mat", "claims.json", "run.json", "figure.svg"})
    CHECK(std::filesystem::exists(folder.path("page/" + made[0] + "/" + name)));
}

TEST_CASE("tables stand where the thesis has them, between its figures") {
  const Scratch folder;
  REQUIRE(run_program(folder, {"thesis", "--only", "fig06,fig04,table1", "--out", "page"}).code == 0);
  const std::string page = content_of(folder.path("page/index.html"));
  const std::size_t cards = page.find("<main>");
  REQUIRE(cards != std::string::npos);
  const auto card = [&](const std::string& label) { return page.find(">" + label + "</span>", cards); };
  CHECK(card("Figure 4") < card("Table 1"));
  CHECK(card("Table 1") < card("Figure 6"));
  CHECK(card("Figure 6") != std::string::npos);
}

TEST_CASE("thesis refuses a page where a file stands") {
  const Scratch folder;
  folder.file("taken", "");
  const Done done = run_program(folder, {"thesis", "--only", "fig31", "--out", "taken"});
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("taken"));
}
