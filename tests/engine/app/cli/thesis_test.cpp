#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Paths of the pages under a folder.
std::vector<fs::path> pages_under(const std::string& folder) {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".html") pages.push_back(entry.path());
  return pages;
}

std::vector<std::string> links_of(const fs::path& page) {
  const std::string text = content_of(page.string());
  const std::regex link("(?:href|src)=\"([^\"#:]+)[\"#]");
  std::vector<std::string> links;
  for (std::sregex_iterator match(text.begin(), text.end(), link), none; match != none; ++match)
    links.push_back((*match)[1]);
  return links;
}

}  // namespace

TEST_CASE("claims of the thesis that repeat the number of a parameter follow it") {
  const Scratch folder;
  const std::string thesis = std::string(STEPWIRE_SOURCE_DIR) + "/diagrams/thesis/";
  const auto run = [&](const std::string& file, const std::string& set) {
    const Done done = run_program(folder, {"run", thesis + file, "--set", set});
    INFO(done.out << done.err);
    CHECK(done.code == 0);
    CHECK_THAT(done.out, !Contains("FAIL"));
  };
  for (const char* set : {"upper=2 mm", "lower=-2.5 mm", "slope=8 N/mm", "limit=0.25 A", "speed=12 mm/s"})
    run("fig15-force-over-1d-map.yaml", set);
  for (const char* set : {"a=4 N", "b=0.8 N/mm", "half=7 mm"}) run("fig32-linear-motor.yaml", set);
}

TEST_CASE("thesis --only makes the figures that are asked for, and pages whose links stay in the folder") {
  const Scratch folder;
  const Done done = run_program(folder, {"thesis", "--only", "fig15,fig31", "--out", "page"});
  INFO(done.err);
  CHECK(done.code == 0);
  int links = 0;
  for (const fs::path& page : pages_under(folder.path("page")))
    for (const std::string& link : links_of(page)) {
      const fs::path target = (page.parent_path() / link).lexically_normal();
      INFO(page << ": " << link);
      CHECK(fs::exists(target));
      CHECK_THAT(target.string(), Catch::StartsWith(folder.path("page/")));
      ++links;
    }
  CHECK(links > 50);
  std::vector<std::string> made;
  for (const auto& entry : fs::directory_iterator(folder.path("page")))
    if (entry.is_directory()) made.push_back(entry.path().filename().string());
  std::sort(made.begin(), made.end());
  REQUIRE(made.size() == 3);
  CHECK(made[0] == "diagrams");
  CHECK_THAT(made[1], Catch::StartsWith("fig15"));
  CHECK_THAT(made[2], Catch::StartsWith("fig31"));
  for (const std::string name : {"index.html", "signals.csv", "claims.json", "run.json", "figure.svg"})
    CHECK(fs::exists(folder.path("page/" + made[1] + "/" + name)));
}

TEST_CASE("the last line of thesis counts claims, and invariants apart") {
  const Scratch folder;
  const Done done = run_program(folder, {"thesis", "--only", "table1", "--out", "page"});
  CHECK(std::regex_search(done.out, std::regex("\n\\d+ claims hold(, \\d+ known not to)?(, \\d+ "
                                               "invariants? held throughout)?\\.\n$")));
}

TEST_CASE("what is printed of a chapter has a page for each picture of its entries") {
  const Scratch folder;
  REQUIRE(run_program(folder, {"thesis", "--only", "fig15,table1", "--out", "page"}).code == 0);
  const std::string page = content_of(folder.path("page/index.html"));
  if (std::system("command -v rsvg-convert >/dev/null") != 0) {
    CHECK_THAT(page, !Contains(".pdf"));
    return;
  }
  std::size_t pictures = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path("page")))
    pictures += entry.path().extension() == ".svg" ? 1 : 0;
  const std::string pdf = content_of(folder.path("page/chapter-2.pdf"));
  const std::regex leaf("/Type */Page[^s]");
  CHECK(pictures >= 3);
  CHECK(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), leaf), std::sregex_iterator()) ==
        static_cast<std::ptrdiff_t>(pictures));
  CHECK_THAT(pdf,
             Contains("/Type /Outlines") && Contains("/Title <FEFF004600690067007500720065002000310035"));
}

TEST_CASE("tables stand where the thesis has them, between its figures") {
  const Scratch folder;
  REQUIRE(run_program(folder, {"thesis", "--only", "fig06,fig04,table1", "--out", "page"}).code == 0);
  const std::string page = content_of(folder.path("page/index.html"));
  const std::size_t cards = page.find("id=\"figures\"");
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
