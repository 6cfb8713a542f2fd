#include "tests/engine/app/studio/live/live_studio.hpp"

#include "engine/app/session/session.hpp"
#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::live {

TEST_CASE("a model that is loaded says what there is to see and to set") {
  Studio studio(swing);
  CHECK_THROWS_WITH(studio.call("run.play"), Catch::Contains("run.load"));
  const Json loaded = studio.call("run.load", R"({"file": 1})");
  CHECK(*loaded.find("step")->as_number() == 1e-3);
  CHECK(*loaded.find("figures")->as_number() == 2.0);
  CHECK(*loaded.find("scene")->as_flag());
  CHECK(*at(*loaded.find("columns"), 0).find("name")->as_text() == "slide.position");
  CHECK(*at(*loaded.find("columns"), 2).find("name")->as_text() == "both.1");
  const Json& mass = at(*loaded.find("parameters"), 0);
  CHECK(*mass.find("text")->as_text() == "2 kg");
  CHECK(*mass.find("low")->as_number() == 0.0);
  CHECK(*mass.find("high")->as_number() == 9.0);
  CHECK(loaded.find("parameters")->text().find("spring.gain") != std::string::npos);
  const Json& scope = at(*loaded.find("scopes"), 0);
  CHECK(loaded.find("scopes")->items().size() == 1);
  CHECK(*at(*scope.find("traces"), 0).find("unit")->as_text() == "mm");
  CHECK(*at(*scope.find("traces"), 0).find("scale")->as_number() == Approx(1000.0));
  CHECK(*at(*loaded.find("inputs"), 0).find("unit")->as_text() == "N");
}

TEST_CASE("frames have the layout of the protocol and wait for their acknowledgement") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  studio.run_to_end();
  studio.call("data.want",
              R"({"views": [{"view": 7, "columns": [0, 1], "from": 0.1, "to": 0.2, "pixels": 100}]})");
  wait_until([&] { return studio.received.frame_count() > 0; });
  const auto [page, bytes] = studio.received.frames.back();
  CHECK(page == 1);
  CHECK(bytes.substr(0, 4) == "SWD1");
  CHECK(number_at<std::uint8_t>(bytes, 4) == 1);
  CHECK(number_at<std::uint8_t>(bytes, 5) == 0);
  CHECK(number_at<std::uint16_t>(bytes, 6) == 7);
  const auto rows = number_at<std::uint32_t>(bytes, 12);
  REQUIRE(rows == 101);
  CHECK(number_at<std::uint16_t>(bytes, 16) == 3);
  CHECK(number_at<double>(bytes, 24) == 3.0);
  REQUIRE(bytes.size() == 32 + 3 * 8 * rows);
  CHECK(number_at<double>(bytes, 32) == 0.1);
  CHECK(number_at<double>(bytes, 32 + 8 * (rows - 1)) == 0.2);
}

TEST_CASE("a page that acknowledges nothing gets two frames of a view and no more") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  studio.call("data.want", R"({"views": [{"view": 1, "columns": [0], "follow": 1, "pixels": 50}]})");
  for (int i = 0; i < 6; ++i) {
    studio.call("run.tick");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  CHECK(studio.received.frame_count() == 2);
  studio.run->acknowledge(1, number_at<std::uint32_t>(studio.received.frames[0].second, 8));
  wait_until([&] { return studio.received.frame_count() == 3; });
  studio.run->left(1);
  studio.run->acknowledge(1, number_at<std::uint32_t>(studio.received.frames[1].second, 8));
  studio.call("run.tick");
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(studio.received.frame_count() == 3);
}

TEST_CASE("figures and claims at the end are those of a run") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  CHECK(*at(*studio.call("claims").find("claims"), 0).find("verdict")->as_text() == "open");
  studio.run_to_end();
  wait_until([&] { return studio.received.last("claims").has_value(); });
  const Json claims = *studio.received.last("claims")->find("claims");
  CHECK(*at(claims, 0).find("verdict")->as_text() == "ok");
  CHECK(*at(claims, 1).find("verdict")->as_text() == "FAIL");
  CHECK(*at(claims, 2).find("verdict")->as_text() == "ok");

  diagram::Loader loader(library());
  loader.add(yaml::parse_document(swing, "swing.yaml"));
  const session::LoadedModel model = session::load_model(loader, "swing.yaml", {});
  const session::Outcome outcome = session::run_model(model, {});
  const Json figures = *studio.call("figures").find("figures");
  REQUIRE(figures.items().size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(figures.items()[i].text() ==
          plot::figure_json(plot::figure_spec(model.figures[i], outcome.recordings())).text());
}

TEST_CASE("a figure grows while the run goes on") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  const std::string before = studio.call("figures").text();
  studio.call("run.seek", R"({"time": 0.5})");
  wait_until([&] {
    const auto news = studio.received.last("run");
    return news && news->find("tick")->as_number() == 500.0;
  });
  CHECK(studio.call("figures").text().size() > before.size());
}

TEST_CASE("what is set is told to all pages with its value and tick") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  const Json echo = studio.call("run.set", R"({"name": "mass", "value": "3000 g"})");
  CHECK(*echo.find("value")->as_number() == 3.0);
  CHECK(*echo.find("tick")->as_number() == 1.0);
  CHECK(*studio.received.last("set")->find("text")->as_text() == "3000 g");
  CHECK(*studio.call("run.set", R"({"name": "mass", "value": 4})").find("value")->as_number() == 4.0);
  CHECK_THROWS_WITH(studio.call("run.set", R"({"name": "mass", "value": "10 kg"})"), Catch::Contains("9 kg"));
  CHECK_THROWS_WITH(studio.call("run.set", R"({"name": "mass"})"), Catch::Contains("'value'"));
}

TEST_CASE("an expression has a unit, is a column, and is read in it") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  const Json signal = studio.call("scope.signal", R"({"expression": "2*slide.position + 1 mm in mm"})");
  CHECK(*signal.find("unit")->as_text() == "mm");
  CHECK(*signal.find("scale")->as_number() == Approx(1000.0));
  CHECK_THROWS_WITH(studio.call("scope.signal", R"({"expression": "slide.position + slide.velocity"})"),
                    Catch::Contains("m/s"));
  CHECK_THROWS_WITH(studio.call("scope.signal", R"({"expression": "slide.positio"})"),
                    Catch::Contains("slide.position"));
  studio.run_to_end();
  const std::string column = std::to_string(static_cast<int>(*signal.find("column")->as_number()));
  const Json seen = studio.call("data.statistics", R"({"from": 0, "to": 3, "columns": [0, )" + column + "]}");
  const Json& plain = at(*seen.find("statistics"), 0);
  const Json& formula = at(*seen.find("statistics"), 1);
  CHECK(*formula.find("max")->as_number() == Approx(2.0 * *plain.find("max")->as_number() + 1e-3));
  const std::string csv =
      *studio.call("data.export", R"({"from": 0, "to": 0.001, "columns": [0, )" + column + "]}")
           .find("csv")
           ->as_text();
  CHECK(csv.find("[mm]") != std::string::npos);
  CHECK(std::ranges::count(csv, '\n') == 3);
}

TEST_CASE("a scene is shown as the newest tick has it, to pages that watch") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  const Json scene = *studio.call("scene").find("scene");
  CHECK(*at(*scene.find("objects"), 0).find("kind")->as_text() == "ball");
  studio.call("run.tick");
  CHECK_FALSE(studio.received.last("scene"));
  studio.call("scene.watch", R"({"on": true})");
  studio.run_to_end();
  wait_until([&] {
    const auto news = studio.received.last("scene");
    return news && news->find("time")->as_number() == 3.0;
  });
  CHECK(studio.received.last("scene")->find("input")->is_null());
  const Json news = *studio.received.last("scene");
  const Json& ball = at(*news.find("shapes"), 0);
  const Json end = studio.call("data.statistics", R"({"from": 3, "to": 3, "columns": [0]})");
  CHECK(at(at(*ball.find("points"), 0), 0).as_number() ==
        at(*end.find("statistics"), 0).find("last")->as_number());
}

TEST_CASE("a scene says up to which sample of its page it shows what the hand did") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  studio.call("scene.watch", R"({"on": true})");
  studio.call("run.input", R"({"samples": [{"time": 77.125, "name": "push", "values": [5]}]})");
  studio.call("run.tick");
  wait_until([&] {
    const auto news = studio.received.last("scene");
    return news && news->find("input")->as_number() == 77.125;
  });
  CHECK(studio.received.last("scene")->find("time")->as_number() == 1e-3);
}

TEST_CASE("a fan has the run of each value, with what is set beside it") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  studio.call("run.set", R"({"name": "spring.gain", "value": "-50 N/m"})");
  const Json fan = studio.call("fan", R"({"name": "mass", "low": 1, "high": 3, "count": 3, "columns": [0]})");
  REQUIRE(fan.find("points")->items().size() == 3);
  const Json& middle = at(*fan.find("points"), 1);
  CHECK(*middle.find("value")->as_number() == 2.0);
  studio.call("run.restart");
  studio.run_to_end();
  const Json& last = at(*middle.find("columns"), 0).items().back();
  const Json end = studio.call("data.statistics", R"({"from": 3, "to": 3, "columns": [0]})");
  CHECK(last.as_number() == at(*end.find("statistics"), 0).find("last")->as_number());
  const Json half =
      studio.call("fan", R"({"name": "mass", "low": -1, "high": 3, "count": 3, "columns": [0]})");
  CHECK(half.find("points")->items().size() == 2);
  CHECK_THROWS_WITH(
      studio.call("fan", R"({"name": "mass", "low": -3, "high": -1, "count": 3, "columns": [0]})"),
      Catch::Contains("mass"));
}

TEST_CASE("inputs of a page that has gone have their defaults") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  studio.call("clock", R"({"page": 1000})");
  studio.call("run.input", R"({"samples": [{"time": 1000.0, "name": "push", "values": [5]}]})");
  studio.call("run.input", R"({"samples": [{"time": 1000.0, "name": "push", "values": [6]}]})", 2);
  studio.call("run.tick");
  studio.run->left(1);
  studio.call("run.tick");
  studio.run->left(2);
  studio.call("run.tick");
  wait_until([&] { return studio.call("run.log").find("events")->items().size() == 3; });
  const Json events = *studio.call("run.log").find("events");
  CHECK(*at(*at(events, 1).find("values"), 0).as_number() == 6.0);
  CHECK(*at(*at(events, 2).find("values"), 0).as_number() == 1.0);
  CHECK(*at(events, 2).find("tick")->as_number() == 3.0);
}

TEST_CASE("blocks of a model are profiled beside its run") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  const Json profile = studio.call("profile");
  CHECK(profile.find("blocks")->items().size() >= 4);
}

TEST_CASE("figures have the values that are set now, and a claim that reads one set on the way is open") {
  const std::string text = R"(stepwire: 1
title: A line
step: 10 ms
stop: 1 s
parameters: {slope: {value: 2, at_most: 9}, other: 5}
record: [line]
blocks: {t: {block: Clock}, line: {block: Gain, u: t, gain: $slope}, idle: {block: Gain, u: t, gain: $other}}
figure: {plot: lines, x: time in s, y: [line in s, $slope * time]}
claims:
  - {that: it is a line, final: line, equals: $slope, within: 1e-9}
  - {that: it rises, final: line, at_least: 0.5}
)";
  Studio studio(text);
  studio.call("run.load", R"({"file": 1})");
  const auto verdict = [&](std::size_t index) {
    const Json claims = *studio.call("claims").find("claims");
    return *at(claims, index).find("verdict")->as_text() + ": " + *at(claims, index).find("text")->as_text();
  };
  const auto set = [&](const std::string& name, const std::string& value) {
    studio.call("run.set", R"({"name": ")" + name + R"(", "value": ")" + value + R"("})");
  };
  set("slope", "3");
  studio.run_to_end();
  CHECK_THAT(verdict(0), Catch::StartsWith("ok"));
  const std::string three = studio.call("figures").text();
  studio.call("run.seek", R"({"time": 0.5})");
  wait_until([&] { return *studio.received.last("run")->find("tick")->as_number() == 50.0; });
  set("slope", "4");
  set("other", "6");
  studio.run_to_end();
  CHECK_THAT(verdict(0), Catch::StartsWith("open") && Catch::Contains("'slope' was set at 0.51 s"));
  CHECK_THAT(verdict(1), Catch::StartsWith("ok"));
  CHECK(studio.call("figures").text() != three);
  studio.call("run.restart");
  wait_until([&] { return *studio.received.last("run")->find("tick")->as_number() == 0.0; });
  studio.run_to_end();
  CHECK_THAT(verdict(0), Catch::StartsWith("ok"));
}

}  // namespace stepwire::live
