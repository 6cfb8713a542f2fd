#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

const std::vector<std::string> which{"base", "mass", "speed"}, what{"", "1 kg", "3 kg", "2 m/s", "8 m/s"};

query::SymbolTable tornado_names() {
  query::SymbolTable names = sample_names();
  names.columns.push_back({"differs", std::nullopt, std::nullopt, "", which});
  names.columns.push_back({"differs_to", std::nullopt, std::nullopt, "", what});
  return names;
}

/// Five settings, each recorded twice: the outcome, and 1 N more.
record::Recording tornado_recording() {
  record::Recording recording;
  recording.starts.clear();
  recording.categories = {{"differs", which}, {"differs_to", what}};
  auto& columns = recording.table.columns;
  columns = {column("time", "s", {}), column("differs", "", {}), column("differs_to", "", {}),
             column("push.force", "N", {})};
  const double first[] = {0, 1, 1, 2, 2}, outcome[] = {5.0, 4.5, 5.5, 2.0, 6.0};
  for (int i = 0; i < 10; ++i) {
    const double row[] = {0.0, first[i / 2], i / 2 * 1.0, outcome[i / 2] + i % 2};
    recording.starts.push_back(static_cast<std::size_t>(i));
    for (std::size_t k = 0; k < 4; ++k) columns[k].values.push_back(row[k]);
  }
  return recording;
}

PlotSpec tornado(const std::string& more) {
  const yaml::Document document = yaml::parse_document("plot: tornado\nx: push.force\n" + more, "f.yaml");
  yaml::Faults faults;
  const auto figures = read_figures(document.root, tornado_names(), faults);
  INFO(all_text(faults));
  REQUIRE(faults.empty());
  const std::vector<record::Recording> recordings{tornado_recording()};
  return std::get<PlotSpec>(figure_spec(figures.at(0), recordings).panels.at(0).content);
}

}  // namespace

TEST_CASE("a tornado has a bar from the file's outcome to each other one, the widest swing on top") {
  const PlotSpec plot = tornado("names: {speed: how fast}");
  REQUIRE(plot.y.named_ticks.size() == 2);
  CHECK((plot.y.named_ticks[0].label == "how fast" && plot.y.named_ticks[1].label == "mass"));
  const auto &first = mark<RectanglesMark>(plot, 0), &last = mark<RectanglesMark>(plot, 1);
  // Means of two rows: 5.5 N with the file's values, 2.5 N and 6.5 N at the ends of speed.
  CHECK(first.x_low == std::vector<double>{2.5, 5.0});
  CHECK(first.x_high == std::vector<double>{5.5, 5.5});
  CHECK(last.x_low == std::vector<double>{5.5, 5.5});
  CHECK(last.x_high == std::vector<double>{6.5, 6.0});
  const auto& base = mark<LineMark>(plot, 2);
  CHECK(base.curves.at(0).x == std::vector<double>{5.5, 5.5});
}

TEST_CASE("behind each bar of a tornado stands the value with its unit") {
  const PlotSpec plot = tornado("");
  REQUIRE(plot.texts.size() == 4);
  CHECK((plot.texts[0].text == "2 m/s" && plot.texts[0].align == TextMark::Align::right));
  CHECK((plot.texts[1].text == "8 m/s" && plot.texts[1].align == TextMark::Align::left));
  CHECK(plot.texts[3].text == "3 kg");
}

TEST_CASE("a tornado shows what `where` selects") {
  CHECK(tornado("where: differs == \"base\" || differs == \"mass\"").y.named_ticks.size() == 1);
  CHECK(tornado("where: differs == \"mass\"").marks.empty());  // nothing to differ from
}

TEST_CASE("a tornado of a file that varies nothing one at a time says what is missing") {
  yaml::Faults faults;
  read_figures(yaml::parse_document("{plot: tornado, x: push.force}", "f.yaml").root, sample_names(), faults);
  CHECK_THAT(all_text(faults), Contains("figure.by") && Contains("differs"));
}

}  // namespace stepwire::plot
