// Rules for a page as a text: its length, its links, its blocks of code.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/pages/page.hpp"

namespace {

constexpr std::size_t max_lines = 400, longest_line = 140;

bool is_there(const std::string& path) {
  return std::filesystem::exists(std::filesystem::path(STEPWIRE_SOURCE_DIR) / path);
}

const Page* page_at(const std::vector<Page>& pages, const std::string& path) {
  for (const Page& page : pages)
    if (page.file == path || page.file == path + "/README.md") return &page;
  return nullptr;
}

bool leads_somewhere(const std::vector<Page>& pages, const Page& from, const std::string& link) {
  const std::string target = target_of(from, link);
  const std::size_t mark = link.find('#');
  if (mark == std::string::npos) return is_there(target);
  const Page* page = page_at(pages, target);
  if (!page) return false;
  const std::vector<std::string> anchors = anchors_of(*page);
  return std::find(anchors.begin(), anchors.end(), link.substr(mark)) != anchors.end();
}

void follow(const std::vector<Page>& pages, const Page& from, std::set<std::string>& seen) {
  if (!seen.insert(from.file).second) return;
  for (const Line& line : from.prose)
    for (const std::string& link : links_in(line.text))
      if (const Page* page = page_at(pages, target_of(from, link))) follow(pages, *page, seen);
}

}  // namespace

TEST_CASE("no page is longer than its limit") {
  for (const Page& page : all_pages()) {
    INFO(page.file);
    const std::vector<Line> lines = lines_of(page.file);
    CHECK(lines.size() <= max_lines);
    for (const Line& line : lines) {
      INFO(line.place());
      CHECK((line.text.size() <= longest_line || line.text.starts_with('|')));
    }
  }
}

TEST_CASE("every link of a page leads to a file or a heading that is there") {
  const std::vector<Page> pages = all_pages();
  for (const Page& page : pages)
    for (const Line& line : page.prose)
      for (const std::string& link : links_in(line.text)) {
        INFO(line.place() << ": " << link);
        CHECK(leads_somewhere(pages, page, link));
      }
}

TEST_CASE("every page is reached from the first one") {
  const std::vector<Page> pages = all_pages();
  std::set<std::string> seen;
  follow(pages, *page_at(pages, "README.md"), seen);
  for (const Page& page : pages) {
    INFO(page.file);
    CHECK(seen.contains(page.file));
  }
}

TEST_CASE("every block of code names its language, so that it is checked as such") {
  const std::set<std::string> known{"sh", "console", "yaml", "csv",  "json",  "cpp",
                                    "c",  "cmake",   "lua",  "toml", "elisp", "js", "python", "text"};
  for (const Page& page : all_pages()) {
    for (const Fence& fence : page.fences) {
      INFO(fence.first.place());
      CHECK(known.contains(fence.language));
    }
    for (const Line& line : page.prose) {
      INFO(line.place() << ": four blanks make a block of code without a language");
      CHECK_FALSE(line.text.starts_with("    "));
    }
  }
}
