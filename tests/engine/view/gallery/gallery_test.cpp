#include "engine/view/gallery/gallery.hpp"

#include <catch2/catch.hpp>

namespace stepwire::gallery {
using Catch::Contains;

namespace {

claim::Verdict verdict(const std::string& that, bool holds, const std::string& disagrees = "") {
  claim::Verdict result{};
  result.that = that;
  result.check = "max x <= 2 N";
  result.shown = "1.5 N";
  result.holds = holds;
  result.disagrees = disagrees;
  return result;
}

claim::Verdict invariant(const std::string& that, bool holds) {
  claim::Verdict result = verdict(that, holds);
  result.kind = claim::Claim::Kind::invariant;
  return result;
}

GalleryEntry entry(const std::string& label = "Figure 15", const std::string& folder = "fig15") {
  GalleryEntry result{};
  result.label = label;
  result.folder = folder;
  result.title = "Force <over> the map";
  result.caption = "A & B";
  return result;
}

std::string front(const std::vector<GalleryEntry>& entries) {
  return gallery_files({"Title", "", entries}).at("index.html");
}

std::string page(const GalleryEntry& one) {
  return gallery_files({"Title", "", {one}}).at(one.folder + "/index.html");
}

}  // namespace

TEST_CASE("the verdict counts claims, and invariants apart from them") {
  GalleryEntry one = entry(), two = entry("Table 1", "table1");
  one.verdicts = {verdict("first", true), verdict("second", false), invariant("limits", true),
                  invariant("energy", true)};
  two.verdicts = {verdict("third", false, "misprint"), verdict("fourth", true, "misprint")};
  CHECK(gallery_verdict({one, two}) ==
        "1 claim holds, 1 known not to, 1 does not hold, 1 holds after all, 2 invariants held "
        "throughout.");
  two.verdicts.push_back(invariant("safety", false));
  CHECK_THAT(gallery_verdict({one, two}), Contains("2 invariants held throughout, 1 invariant is broken."));
}

TEST_CASE("the front page links first to what ends otherwise than expected") {
  GalleryEntry one = entry(), two = entry("Table 1", "table1");
  one.verdicts = {verdict("first", true), verdict("second", false)};
  two.verdicts = {verdict("third", false, "misprint"), verdict("fourth", true, "misprint")};
  const std::string text = front({one, two});
  CHECK_THAT(
      text,
      Contains("<li><a href=\"fig15/index.html\">Figure 15: Force &lt;over&gt; the map</a>: second – does "
               "not hold</li>"));
  CHECK_THAT(text, Contains("fourth – holds after all"));
  CHECK_THAT(text, !Contains("third – "));
  CHECK(text.find("id=\"unexpected\"") < text.find("id=\"disagrees\""));
  CHECK(text.find("id=\"disagrees\"") < text.find("id=\"figures\""));
}

TEST_CASE("a front page on which all holds says only that") {
  GalleryEntry one = entry();
  one.verdicts = {verdict("first", true)};
  CHECK_THAT(front({one}), Contains("<p class=\"summary good\">1 claim holds.</p>"));
  CHECK_THAT(front({one}), !Contains("id=\"unexpected\""));
}

TEST_CASE("no text of a diagram becomes part of a page other than as text") {
  const std::string text = "</pre><script>alert(\"1\")</script>&'";
  const std::string escaped = "&lt;/pre&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;";
  GalleryEntry one = entry(text, "a folder");
  one.title = one.caption = one.source_caption = one.source_says = one.section = one.error = one.note = text;
  one.departures = {text};
  one.verdicts = {verdict(text, false, text), verdict(text, false), invariant(text, true)};
  one.verdicts[1].note = one.verdicts[0].check = one.verdicts[0].shown = text;
  one.assumptions = {{text, text, text}};
  one.pictures = {{text, text, text, text, 100.0, 100.0, false, false},
                  {text, text, text, text, 1.0, 1.0, true, true}};
  one.downloads = {{text + ".svg", 1}};
  one.sources = {{"diagrams/a.yaml", text + "\nkey: " + text + " # " + text + "\n- \"" + text + "\"\n"}};
  for (const auto& [place, content] : gallery_files({text, text, {one, one}})) {
    if (!place.ends_with(".html")) continue;
    INFO(place);
    CHECK_THAT(content, !Contains("<script>") && !Contains("alert(\"") && !Contains("=\"</pre>"));
    CHECK_THAT(content, Contains(escaped.substr(5, 20)));
  }
}

TEST_CASE("what disagrees, departures and what is assumed stand on the front, with their entries") {
  GalleryEntry one = entry(), two = entry("Table 3", "table3");
  one.verdicts = {verdict("first", true), verdict("second", false, "a <misprint>")};
  one.departures = {"0.35 A in place of 1 A"};
  one.assumptions = {{"speed", "10 mm/s", "of the push"}};
  two.assumptions = {{"rig.speed", "10 mm/s", "of the push"}, {"a", "5 N", "offset"}};
  const std::string text = front({one, two});
  CHECK_THAT(text, Contains("<li>second<br><em>a &lt;misprint&gt;</em></li>"));
  CHECK_THAT(text, Contains("<li>0.35 A in place of 1 A</li>"));
  CHECK_THAT(text, Contains("<h2>What is assumed</h2> <span class=\"count\">2 values</span>"));
  CHECK_THAT(
      text,
      Contains("<tr><td><code>speed</code></td><td>10 mm/s</td><td>of the push</td><td><a "
               "href=\"fig15/index.html\">Figure 15</a>, <a href=\"table3/index.html\">Table 3</a></td>"));
}

TEST_CASE("a chapter is summed up at its head, where an entry is of it") {
  GalleryEntry one = entry();
  one.section = "4.3.1";
  one.departures = {"0.35 A in place of 1 A"};
  const std::vector<ChapterSummary> summaries{{"4", "In brief", {"Walls <cost>.", "Two."}},
                                              {"5", "Not made", {"Three."}}};
  const std::string text = gallery_files({"Title", "", {one}, summaries}).at("index.html");
  CHECK_THAT(text, Contains("<h4>In brief</h4>\n<p>Walls &lt;cost&gt;.</p>\n<p>Two.</p>"));
  CHECK(text.find("id=\"departures\"") < text.find("<h3>Chapter 4</h3>"));
  CHECK(text.find("<h3>Chapter 4</h3>") < text.find("In brief"));
  CHECK(text.find("In brief") < text.find("class=\"cards\""));
  CHECK_THAT(text, !Contains("Not made"));
}

TEST_CASE("thumbnails stand under their chapters, and show what the source has") {
  GalleryEntry one = entry(), two = entry("Table 3", "table3");
  one.section = "2.5.1";
  two.section = "4.3.1";
  one.pictures = {{"own.svg", "", "", "of our own", 640.0, 480.0, true, false},
                  {"theirs.svg", "", "", "as in the thesis", 700.0, 350.0, false, true}};
  const std::string text = front({one, two});
  const std::size_t second = text.find("<h3>Chapter 2</h3>"), fourth = text.find("<h3>Chapter 4</h3>");
  REQUIRE(second < fourth);
  REQUIRE(fourth != std::string::npos);
  const std::string of_second = text.substr(second, fourth - second);
  CHECK_THAT(of_second, Contains("<img src=\"fig15/theirs.svg\" width=\"700\" height=\"350\""));
  CHECK_THAT(of_second, !Contains("own.svg") && !Contains("table3/"));
  one.pictures[1].dense = true;
  CHECK_THAT(front({one, two}), Contains("<span class=\"thumb dense\">"));
  CHECK_THAT(text.substr(fourth), Contains("href=\"table3/index.html\""));
}

TEST_CASE("a page has its neighbours, its pictures with words, and its words beside the source's") {
  GalleryEntry one = entry(), two = entry("Figure 16", "fig16"), three = entry("Figure 17", "fig17");
  two.source_caption = "Caption of the thesis";
  two.source_says = "Sentence of the thesis";
  two.pictures = {{"figure.svg", "", "Below it", "force over time", 700.0, 350.0, false, true},
                  {"figure-2.svg", "", "", "the loop", 100.0, 100.0, true, true}};
  const std::string text = gallery_files({"Title", "", {one, two, three}}).at("fig16/index.html");
  CHECK_THAT(text, Contains("rel=\"prev\" href=\"../fig15/index.html\"") &&
                       Contains("rel=\"next\" href=\"../fig17/index.html\""));
  CHECK_THAT(text, Contains("src=\"figure.svg\" width=\"1050\" height=\"525\" alt=\"force over time\""));
  CHECK_THAT(text, Contains("<figcaption>Below it</figcaption>"));
  CHECK_THAT(text, Contains("<p class=\"caption\">Caption of the thesis</p>\n<p>Sentence of the thesis</p>"));
  CHECK(text.find("figure-2.svg") > text.find("<h2>Of our own</h2>"));
  CHECK(text.find("figure.svg") < text.find("<h2>Of our own</h2>"));
}

TEST_CASE(
    "a large picture is not shown smaller than a page lets it be, a small one not larger than a screen") {
  GalleryEntry one = entry();
  one.pictures = {{"wide.svg", "", "", "wide", 2800.0, 400.0, false, true},
                  {"tall.svg", "", "", "tall", 700.0, 1400.0, false, true},
                  {"small.svg", "", "", "small", 200.0, 100.0, false, true},
                  {"square.svg", "", "", "square", 640.0, 640.0, false, true}};
  CHECK_THAT(page(one), Contains("src=\"wide.svg\" width=\"1400\" height=\"200\""));
  CHECK_THAT(page(one), Contains("src=\"tall.svg\" width=\"700\" height=\"1400\""));
  CHECK_THAT(page(one), Contains("src=\"small.svg\" width=\"300\" height=\"150\""));
  CHECK_THAT(page(one), Contains("src=\"square.svg\" width=\"820\" height=\"820\""));
}

TEST_CASE("invariants that hold are folded into a line, one that is broken is not") {
  GalleryEntry one = entry();
  one.verdicts = {verdict("claim", true), invariant("limits", true), invariant("energy", true),
                  invariant("safety", false)};
  const std::string text = page(one);
  const std::size_t folded = text.find("<details id=\"invariants\">\n<summary>Held throughout: 2</summary>");
  REQUIRE(folded != std::string::npos);
  CHECK(text.find(">claim<") < folded);
  CHECK(text.find(">safety<") < folded);
  CHECK(text.find(">limits<") > folded);
}

TEST_CASE(
    "a diagram file lies in the gallery as it is, and its parts have pages that say where they are used") {
  GalleryEntry one = entry();
  const std::string part = "title: A hand\n", file = "blocks:\n  hand: {diagram: ../parts/hand.yaml}\n";
  one.sources = {{"diagrams/thesis/fig15.yaml", file}, {"diagrams/parts/hand.yaml", part}};
  const auto files = gallery_files({"Title", "", {one}});
  CHECK(files.at("diagrams/thesis/fig15.yaml") == file);
  CHECK(files.at("diagrams/parts/hand.yaml") == part);
  CHECK_THAT(files.at("fig15/index.html"),
             Contains("<a href=\"../diagrams/parts/hand.yaml.html\">../parts/hand.yaml</a>"));
  CHECK_THAT(files.at("diagrams/parts/hand.yaml.html"),
             Contains("<a href=\"../../fig15/index.html\">Figure 15</a>"));
}

TEST_CASE("a file that another entry keeps is linked there, and packed files are named by their kind") {
  GalleryEntry one = entry(), two = entry("Figure 16", "fig16");
  one.downloads = {{"signals.csv.gz", 1234567}};
  two.downloads = {{"signals.csv.gz", 1234567, "fig15", "Figure 15"}, {"figure.json", 300000}};
  const auto files = gallery_files({"Title", "", {one, two}});
  CHECK_THAT(files.at("fig15/index.html"),
             Contains("<a href=\"signals.csv.gz\" download>signals.csv.gz</a>"));
  CHECK_THAT(
      files.at("fig16/index.html"),
      Contains("<a href=\"../fig15/signals.csv.gz\" download>signals.csv.gz</a> <span class=\"soft\">1.2 "
               "MB</span><span class=\"soft\">, the same as of Figure 15</span>") &&
          Contains("<dt>Of the run</dt>"));
}

TEST_CASE("an entry names its pages of what is printed for its chapter") {
  GalleryEntry one = entry(), two = entry("Figure 16", "fig16");
  one.section = two.section = "2.5";
  one.pictures = {{"a.svg", "", "", "a", 10.0, 10.0}};
  two.pictures = {{"b.svg", "", "", "b", 10.0, 10.0}, {"c.svg", "", "", "c", 10.0, 10.0}};
  CHECK_THAT(front({one, two}), !Contains(".pdf"));
  one.print = {"chapter-2.pdf", 1};
  two.print = {"chapter-2.pdf", 2};
  const auto files = gallery_files({"Title", "", {one, two}});
  CHECK_THAT(files.at("index.html"),
             Contains("<a href=\"chapter-2.pdf\">Its figures with captions as PDF</a>"));
  CHECK_THAT(
      files.at("fig15/index.html"),
      Contains("<a href=\"../chapter-2.pdf#page=1\">chapter-2.pdf</a> <span class=\"soft\">page 1</span>"));
  CHECK_THAT(files.at("fig16/index.html"),
             Contains("#page=2\">chapter-2.pdf</a> <span class=\"soft\">pages 2 to 3</span>"));
}

}  // namespace stepwire::gallery
