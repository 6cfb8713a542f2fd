// Each key of each kind of plot changes the picture that the file makes, or is refused.
#include <catch2/catch.hpp>
#include <map>

#include "blocks/register.hpp"
#include "engine/app/session/session.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "tests/engine/app/cli/small_study.hpp"

namespace stepwire::session {

namespace {

using Keys = std::map<std::string, std::string>;

/// In place of a value of a key that many curves alone show, for which there is a row of its own.
const std::string of_many = "of many curves";

/// A kind of plot: the sections of its file beside the cart, the keys that it is drawn with, and values that
/// other keys have in place of the usual ones.
struct Drawn {
  std::string kind, sections;
  Keys keys, own;
};

const std::string
    three_runs = "sweep: {k: [100 N/m, 200 N/m, 300 N/m]}\n",
    analyses = three_runs +
               "linear: {loop: {from: spring, to: spring, open: spring}, other: {from: push, to: "
               "cart.position}}\n",
    drawn_runs =
        "sweep: {k: {uniform: [100 N/m, 200 N/m]}, cart.mass: {uniform: [1 kg, 2 kg]}, design: "
        "{samples: 8, kind: saltelli}}\nsensitivity: {of: {peak: max(cart.position), other: "
        "max(spring)}}\n",
    one_differs = "sweep: {one_at_a_time: {k: [50 N/m, 200 N/m], cart.mass: [2 kg, 3 kg]}}\n",
    a_scene =
        "scene: {view: {x: [-80 mm, 80 mm], y: [-80 mm, 80 mm]}, objects: {hand: {ball: hand, radius: "
        "4 mm}}}\n",
    x = "cart.position in mm", v = "cart.velocity in mm/s", two_x = "2*cart.position in mm",
    many_runs = "sweep: {k: {from: 100 N/m, to: 200 N/m, count: 12}}\n",
    over_time = "{x: time, y: cart.position}",
    rose_over_time = "{x: time, y: cart.position, angle: time*6/(1 s), value: push, radius: 0.1 s}";

const Keys in_plane{
    {"marks", "{A: [1 mm, 2 mm]}"}, {"texts", "{A: [1 mm, 2 mm]}"}, {"y_range", "[0 mm, 9 mm]"}};
/// Both together.
Keys with(Keys keys, const Keys& others) {
  keys.insert(others.begin(), others.end());
  return keys;
}

const Keys of_lines{{"x", "2*time in s"},
                    {"y", two_x},
                    {"x_range", "[0.1 s, 0.5 s]"},
                    {"y_range", "[0 mm, 9 mm]"},
                    {"marks", "{A: [0.1 s, 2 mm]}"},
                    {"texts", "{A: [0.1 s, 2 mm]}"},
                    {"motion", over_time},
                    {"rose", rose_over_time}};
const Keys of_many_in_plane = with(in_plane, {{"by", "k > 150 N/m"}, {"color_range", "[0 N/m, 300 N/m]"}});
const Keys of_analysis{
    {"x_range", "[1, 10]"}, {"y_range", "[-10, 10]"}, {"boundary", "x + 0.5"}, {"legend", "[a]"}};

const std::vector<Drawn>& every_plot() {
  static const std::vector<Drawn> all{
      {"lines",
       three_runs,
       {{"x", "time in s"}, {"y", x}},
       with(of_lines, {{"color_label", of_many}, {"color_range", of_many}})},
      {"lines",
       many_runs,
       {{"x", "time in s"}, {"y", x}, {"by", "k"}},
       with(of_lines, {{"by", "k > 150 N/m"}, {"color_range", "[0 N/m, 300 N/m]"}, {"log", "color"}})},
      {"xy", many_runs, {{"x", x}, {"y", "hand.2 in mm"}, {"by", "k"}}, of_many_in_plane},
      {"loop", many_runs, {{"x", x}, {"y", "hand.2 in mm"}, {"by", "k"}}, of_many_in_plane},
      {"path", three_runs, {{"x", x}, {"y", "hand.2 in mm"}, {"color", "push"}}, in_plane},
      {"strip", three_runs, {{"x", x}, {"color", "push"}}, {}},
      {"map", three_runs, {{"x", x}, {"y", "hand.2 in mm"}, {"color", "push"}}, in_plane},
      {"field", three_runs, {{"x", x}, {"y", "hand.2 in mm"}, {"u", "push"}, {"v", "spring"}}, in_plane},
      {"3d",
       three_runs,
       {{"x", x}, {"y", v}, {"z", "push"}},
       {{"style", "points"}, {"y_range", "[0 mm/s, 9 mm/s]"}}},
      {"3d",
       three_runs,
       {{"x", x}, {"y", v}, {"z", "push"}, {"color", "spring"}},
       {{"style", "points"}, {"y_range", "[0 mm/s, 9 mm/s]"}}},
      {"box", three_runs, {{"y", x}}, {{"y", two_x}, {"y_range", "[0 mm, 9 mm]"}, {"log", "y"}}},
      {"histogram", three_runs, {{"x", x}}, {{"y_range", "[0, 9]"}}},
      {"band", three_runs, {{"x", "time in s"}, {"y", x}}, of_lines},
      {"tornado",
       one_differs,
       {{"x", x}},
       {{"where", "time < 0.5 s"}, {"by", "differs_to"}, {"to", "differs"}}},
      {"sensitivity", drawn_runs, {{"of", "peak"}}, {{"x_range", "[0, 0.5]"}}},
      {"diagram", "", {}, {{"hide", "map"}, {"names", "{cart: wagon}"}}},
      {"rig",
       "",
       {{"points", "{p: [hand.1, hand.2, 5 mm]}"}, {"elements", "[{rod: [[0 mm, 0 mm, 0 mm], p]}]"}},
       {{"where", "time > 0.5 s"},
        {"points", "{p: [hand.1, hand.2, 9 mm]}"},
        {"axes", "[x, z]"},
        {"up", "z"},
        {"schematic", "true"},
        {"elements", "[{rod: [[1 mm, 0 mm, 0 mm], p]}]"}}},
      {"scene", three_runs + a_scene, {}, {{"words", "now"}, {"where", "time > 0.5 s"}}},
      {"table",
       "",
       {{"headings", "[a, b]"}, {"rows", "{first: [cart.position in mm]}"}},
       {{"of", "anova"}, {"headings", "[a, c]"}, {"rows", "{first: [spring]}"}, {"where", "time > 0.3 s"}}},
      {"bode",
       analyses,
       {{"of", "loop"}},
       {{"x_range", "[1, 10]"}, {"y_range", "[-10, 10]"}, {"boundary", "x - 5"}, {"legend", "[a]"}}},
      {"nyquist", analyses, {{"of", "loop"}}, of_analysis},
      {"poles", analyses, {{"of", "loop"}}, of_analysis},
      {"root_locus", analyses, {{"of", "loop"}}, of_analysis},
      {"step_response",
       analyses,
       {{"of", "other"}},
       {{"of", "loop"}, {"x_range", "[0, 1]"}, {"y_range", "[0, 1]"}}}};
  return all;
}

/// A value of a key, other than what holds without it.
const Keys& usual_values() {
  static const Keys all{{"title", "other"},
                        {"caption", "words"},
                        {"own", "true"},
                        {"size", "[700, 500]"},
                        {"columns", "3"},
                        {"where", "k > 150 N/m"},
                        {"rows", "final"},
                        {"legend", "[first]"},
                        {"equal", "true"},
                        {"x_label", "across"},
                        {"y_label", "up"},
                        {"z_label", "third"},
                        {"color_label", "hue"},
                        {"log", "x"},
                        {"note", "{signal: push, label: at}"},
                        {"region", "map"},
                        {"region_line", "dashes"},
                        {"boundary", "x - 5 mm"},
                        {"by", "k"},
                        {"reference", "30 mm"},
                        {"style", "[dashes]"},
                        {"shade", "[0.2 s, 0.4 s]"},
                        {"low", "cart.position - 1 mm"},
                        {"high", "cart.position + 1 mm"},
                        {"motion", "{x: hand.1, y: hand.2}"},
                        {"rose", "{x: hand.1, y: hand.2, angle: time*6/(1 s), value: push, radius: 4 mm}"},
                        {"x_range", "[-1 mm, 9 mm]"},
                        {"y_range", "[0 mm, 9 mm]"},
                        {"z_range", "[0 N, 3 N]"},
                        {"color_range", "[0 N, 3 N]"},
                        {"x", two_x},
                        {"y", "2*hand.2 in mm"},
                        {"color", "2*push"},
                        {"z", "2*push"},
                        {"u", "2*push"},
                        {"v", "2*push"},
                        {"bins", "7"},
                        {"reduce", "max"},
                        {"lines", "20 mm"},
                        {"cells", "9"},
                        {"gap", "1"},
                        {"contour", "[3 N]"},
                        {"scale", "3"},
                        {"pivot", "tip"},
                        {"shares", "[30 %]"},
                        {"whiskers", "tukey"},
                        {"beside", "push > 5 N"},
                        {"elevation", "30"},
                        {"azimuth", "10"},
                        {"names", "{k: stiffness}"},
                        {"sheets", "[k < 150 N/m, k > 150 N/m]"},
                        {"of", "other"},
                        {"at", "0.7 s"},
                        {"open", "half"},
                        {"depth", "1"},
                        {"labels", "{push: F_p}"},
                        {"groups", "{g: [spring, damper]}"},
                        {"units", "true"}};
  return all;
}

/// Keys that need another one, which is then there before and after.
const Keys& partners() {
  static const Keys all{{"low", "high"}, {"high", "low"}, {"region_line", "region"}};
  return all;
}

std::string file_of(const Drawn& drawn, const Keys& keys) {
  std::string figure = "plot: " + drawn.kind;
  for (const auto& [key, value] : keys) figure += ", " + key + ": " + value;
  return "stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nparameters: {k: 100 N/m}\nblocks:\n"
         "  push: {block: Sine, amplitude: 5 N, frequency: 1 Hz, bias: 5 N}\n"
         "  net: {block: Sum, signs: \"+--\", u: [push, spring, damper]}\n"
         "  cart: {block: Mass, force: net, mass: 1 kg}\n"
         "  spring: {block: Gain, u: cart.position, gain: $k}\n"
         "  damper: {block: Gain, u: cart.velocity, gain: 3 N s/m}\n"
         "  map: {block: Region, shape: {center: [0 mm, 0 mm], radius: 8 mm}, position: hand}\n"
         "  hand: {block: Mux, u: [cart.position, y2]}\n"
         "  y2: {block: Gain, u: cart.velocity, gain: 0.1 s}\n"
         "  half: {diagram: half.yaml, u: push}\n"
         "record: [push, cart.position, cart.velocity, spring, damper, hand, map.distance, map.nearest]\n" +
         drawn.sections + "figure: {" + figure + "}\n";
}

/// The picture of a file with its texts in the gallery, or the message of its refusal.
struct Picture {
  std::string text, refusal;
};

Picture picture_of(const std::string& text) {
  static const Registry library = blocks();
  const Scratch folder;
  folder.file("cart.yaml", text);
  folder.file(
      "half.yaml",
      "stepwire: 1\ntitle: half\ninputs: {u: {unit: N}}\nblocks: {y: {block: Gain, u: u, gain: 0.5}}\n"
      "outputs: {y: y}\n");
  Session session(library);
  try {
    const LoadedModel model = session.load(folder.path("cart.yaml"));
    const Outcome outcome = session.run(model);
    const plot::Figure& figure = model.figures.at(0);
    return {plot::figure_json(plot::figure_spec(figure, outcome.recordings())).text(-1) + figure.caption +
                (figure.own ? "own" : ""),
            ""};
  } catch (const yaml::Error& error) {
    return {"", error.what()};
  }
}

void check_key(const Drawn& drawn, const std::string& key) {
  const auto own = drawn.own.find(key), usual = usual_values().find(key);
  if (own != drawn.own.end() && own->second == of_many) return;
  INFO("plot: " << drawn.kind << ", " << key);
  REQUIRE((own != drawn.own.end() || usual != usual_values().end()));
  Keys before = drawn.keys;
  if (const auto partner = partners().find(key); partner != partners().end())
    before[partner->second] = usual_values().at(partner->second);
  Keys after = before;
  after[key] = own != drawn.own.end() ? own->second : usual->second;
  const Picture with = picture_of(file_of(drawn, after));
  INFO(with.refusal);
  if (!with.refusal.empty()) return;
  const bool changes = with.text != picture_of(file_of(drawn, before)).text;
  CHECK(changes);
}

}  // namespace

TEST_CASE("each key of each kind of plot changes its picture, or is refused", "[full]") {
  for (const Drawn& drawn : every_plot()) {
    const auto& kinds = plot::plot_kinds();
    const auto kind = std::ranges::find(kinds, drawn.kind, &plot::PlotKind::name);
    const Picture base = picture_of(file_of(drawn, drawn.keys));
    INFO(drawn.kind << ": " << base.refusal);
    REQUIRE(base.refusal.empty());
    for (const yaml::Key& key : plot::plot_form(*kind, true).of)
      if (key.name != "plot") check_key(drawn, key.name);
  }
}

TEST_CASE("a walk over keys goes over all kinds of plots") {
  for (const plot::PlotKind& kind : plot::plot_kinds()) {
    INFO(kind.name);
    CHECK(std::ranges::find(every_plot(), kind.name, &Drawn::kind) != every_plot().end());
  }
}

}  // namespace stepwire::session
