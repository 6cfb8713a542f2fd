// Drawings in pages are kept as files, and are those that the program draws today.
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/pages/page.hpp"
#include "tests/pages/workbench.hpp"

namespace {

std::string picture(const std::string& name) {
  return content_of(std::filesystem::path(STEPWIRE_SOURCE_DIR) / "diagrams/pictures" / name);
}

void check_drawing(const Workbench& bench, const std::string& arguments, const std::string& name) {
  const Outcome drawn = bench.run("./stepwire draw " + arguments);
  INFO(name << " is drawn by: ./stepwire draw " << arguments << " -o diagrams/pictures/" << name);
  if (drawn.code == 3)
    WARN("skipped: " << drawn.output);
  else
    CHECK((drawn.code == 0 && drawn.output == picture(name)));
}

}  // namespace

TEST_CASE("the drawing on the first page is that of its first diagram") {
  const Workbench bench;
  for (const Page& page : all_pages())
    if (page.file == "README.md") bench.write("cart.yaml", page.fences.at(1).text);
  check_drawing(bench, "cart.yaml", "cart-diagram.svg");
}

TEST_CASE("the drawing on the page of the command line is what its command draws") {
  check_drawing(Workbench(), "diagrams/thesis/fig14-controller-1d.yaml --open map", "controller-1d.svg");
}

TEST_CASE("the drawing on the page of git is what its commands draw") {
  const Workbench bench;
  for (const Page& page : all_pages())
    if (page.file == "diagrams/git.md") {
      bench.write("cart.yaml", page.fences.at(0).text);
      std::istringstream commands(page.fences.at(1).text);
      for (std::string line; std::getline(commands, line);)
        if (line.starts_with("$ ") && line.find(" -o ") == line.npos) bench.run(line.substr(2));
    }
  const Outcome drawn =
      bench.run("./stepwire diff cart.yaml new.yaml -o drawn.svg > /dev/null; cat drawn.svg");
  if (drawn.output.find("<svg") == std::string::npos)
    WARN("skipped: " << drawn.output);
  else
    CHECK(drawn.output == picture("cart-diff.svg"));
}
