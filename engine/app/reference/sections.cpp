#include "engine/app/reference/sections.hpp"

#include <algorithm>
#include <map>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/analyse/sensitivity/sensitivity.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/simulate/solve/solver.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::reference {
namespace {

const char* const head_example = R"yaml(stepwire: 1
title: A body on a spring
step: 1 ms
stop: 1 s
solver: rk4
parameters:
  mass: {value: 1 kg, above: 0 kg, doc: of the body}
blocks:
  spring: {block: Gain, u: body.position, gain: -400 N/m}
  body:   {block: Mass, force: spring, mass: $mass, initial_position: 20 mm}
record: [body.position, body.velocity, spring])yaml";

const char* const parameters_example = R"yaml(parameters:
  mass:  {value: 1 kg, above: 0 kg, at_most: 5 kg, doc: of the body}
  drop:  20 mm
  swing: {value: 3.2, unit: Hz, doc: how fast, assumed: true}
  stiff: = mass * (2*pi*swing)^2
blocks:
  spring: {block: Gain, u: body.position, gain: = -stiff}
  body:   {block: Mass, force: spring, mass: $mass, initial_position: $drop})yaml";

const char* const inputs_example = R"yaml(inputs:
  push: {unit: N, default: 0 N, doc: a hand at the body}
blocks:
  spring: {block: Gain, u: body.position, gain: -400 N/m}
  sum:    {block: Sum, u: [spring, push]}
  body:   {block: Mass, force: sum, mass: $mass, initial_position: 20 mm})yaml";

const char* const claims_example = R"yaml(claims:
  - {that: it swings as far as it was pulled, max: abs(body.position), equals: 20 mm, within: 1 %}
  - {that: its speed is zero at first, at: {time: 0 s, value: body.velocity}, equals: 0 m/s}
  - {that: the force rises as it goes down, rising: {value: spring, over: -body.position}, at_least: 0.99}
  - {that: half of the time it is above, where: time < 0.9 s, fraction: body.position > 0, between: [0.4, 0.6]})yaml";

const char* const scene_example = R"yaml(scene:
  view: {x: [-30 mm, 30 mm], y: [-10 mm, 10 mm]}
  objects:
    spring: {rod: [[-30 mm, 0], [body.position, 0]], width: 1 mm}
    body:   {ball: [body.position, 0], radius: 3 mm, color: {red: abs(body.velocity) > 0.3, else: blue}}
  animation: {from: 0 s, to: 1 s, speed: 0.5})yaml";

const char* const fit_example = R"yaml(fit:
  parameters: {mass: {start: 1.5 kg, bounds: [0.5 kg, 3 kg]}}
  compare: [{model: body.position in mm, measured: "20 mm * cos(20*time)", weight: 1/(1 mm)}]
  starts: 4
  global: {population: 8, generations: 2})yaml";

const char* const tune_example = R"yaml(tune:
  parameters: {mass: {from: 0.5 kg, to: 3 kg, start: 1.5 kg}}
  minimise: rms(spring)/(1 N) + max(abs(body.velocity) where time < 0.5 s)/(1 m/s)
  subject_to: [{that: it swings as far, max: body.position, at_least: 19 mm}]
  starts: 2)yaml";

const char* const linear_example = R"yaml(linear:
  loop: {from: spring, to: spring, open: spring, at: 0.2 s})yaml";

const char* const sensitivity_example =
    "sweep: {mass: {uniform: [1 kg, 2 kg]}, design: {samples: 16, kind: saltelli}}\n"
    "sensitivity: {of: {swing: max(body.velocity)}, confidence: 90 %}";

const char* const study_example = R"yaml(stepwire: 1
title: People who draw a circle
step: 10 ms
stop: 4 s
solver: rk4
stop_when: turned > 6.2832
parameters: {subject: 1, seed: 1, haptic: 0, visual: 0, center_x: 0 mm, center_y: 0 mm, radius: 20 mm}
blocks:
  turned: {block: Ramp, slope: 2.5}
  noise:  {block: Noise, seed: "= seed + 100*subject", deviation: "= 10 mm / (1 + haptic + visual)", every: 50 ms}
  sway:   {block: Lag, u: noise, tau: 0.1 s}
  far:    {block: Sum, u: [sway, $radius]}
  x:      {block: Expression, u: [far, turned], expression: u1*cos(u2) + $center_x}
  y:      {block: Expression, u: [far, turned], expression: u1*sin(u2) + $center_y}
  hand:   {block: Mux, u: [x, y]}
units: {x: m, y: m}
record: {every: 50 ms, signals: [hand]}
study:
  task: 1
  subjects: 6
  sets: {subject: subject, seed: seed}
  conditions: {NO: {}, H: {haptic: 1}, V: {visual: 1}, HV: {haptic: 1, visual: 1}}
  circle: {of: NO, sets: {x: center_x, y: center_y, radius: radius}}
  position: hand)yaml";

std::string figure(const std::string& rest) {
  return "figure: {plot: " + rest + "}";
}

std::string linear_figure(const std::string& plot) {
  return std::string(linear_example) + "\n" + figure(plot + ", of: loop, title: The loop of the spring");
}

const std::map<std::string, std::string>& examples() {
  static const std::map<std::string, std::string> all{
      {"head", head_example},
      {"parameters", parameters_example},
      {"inputs", inputs_example},
      {"outputs", "outputs:\n  place: {signal: body.position, unit: m, safe: 0 m, doc: of the body}"},
      {"record", "record:\n  - {every: 10 ms, signals: {place: body.position, pull: spring}}\n  - all"},
      {"sweep", "sweep: {mass: {from: 1 kg, to: 2 kg, count: 5}}"},
      {"claims", claims_example},
      {"scene", scene_example},
      {"fit", fit_example},
      {"tune", tune_example},
      {"linear", linear_example},
      {"trim",
       "trim:\n  states: {body.velocity: {fixed: 0 m/s}, body.position: {start: 1 mm, bounds: [-1 m, 1 "
       "m]}}\n  "
       "outputs: {spring: free}"},
      {"sensitivity", sensitivity_example},
      {"study", study_example},
      {"figure",
       "figure:\n  panels:\n    - {plot: lines, x: time in s, y: body.position in mm}\n    - {plot: "
       "loop, x: body.position in mm, y: spring in N, legend: [the spring]}\n  columns: 2\n  title: "
       "The body\n  size: [900, 400]"},
      {"figure.lines",
       figure("lines, x: time in s, y: [body.position in mm], y_range: [-25 mm, 25 mm], legend: [body]")},
      {"figure.xy", figure("xy, x: body.position in mm, y: body.velocity in mm/s")},
      {"figure.loop", figure("loop, x: body.position in mm, y: spring in N, style: dashes")},
      {"figure.path", figure("path, x: body.position in mm, y: body.velocity in mm/s, color: time in s")},
      {"figure.strip", figure("strip, x: time in s, color: body.position in mm")},
      {"figure.map",
       figure("map, x: body.position in mm, y: body.velocity in mm/s, color: time in s, cells: 40")},
      {"figure.field",
       figure("field, x: body.position, y: body.velocity, u: body.velocity, v: spring, cells: 20")},
      {"figure.3d", figure("3d, x: time, y: body.position in mm, z: body.velocity in mm/s, style: points")},
      {"figure.box", figure("box, y: body.position in mm, whiskers: tukey")},
      {"figure.tornado", std::string("sweep: {one_at_a_time: {mass: [1 kg, 3 kg]}}\n") +
                             figure("tornado, x: body.position in mm, names: {mass: mass of the body}")},
      {"figure.band", std::string("sweep: {mass: {uniform: [1 kg, 2 kg]}, design: {samples: 20}}\n") +
                          figure("band, x: time in s, y: body.position in mm, shares: [50 %, 90 %]")},
      {"figure.sensitivity", std::string(sensitivity_example) + "\n" +
                                 figure("sensitivity, of: swing, names: {mass: mass of the body}")},
      {"figure.histogram", figure("histogram, x: body.position in mm, bins: 20, lines: 0 mm")},
      {"figure.diagram", figure("diagram, names: {body: load}, units: true")},
      {"figure.rig",
       "figure:\n  plot: rig\n  points: {wall: [-40 mm, 0], pin: [body.position, 0]}\n  elements: [{spring: "
       "[wall, "
       "pin]}, {ground: wall}]\n  schematic: true"},
      {"figure.table",
       "figure:\n  plot: table\n  headings: [what, value]\n  rows: {place: body.position in mm}\n  where: "
       "time > 0.5"},
      {"figure.bode", linear_figure("bode")},
      {"figure.nyquist", linear_figure("nyquist")},
      {"figure.poles", linear_figure("poles")},
      {"figure.root_locus", linear_figure("root_locus")},
      {"figure.step_response", linear_figure("step_response")},
      {"figure.scene",
       std::string(scene_example) + "\nfigure: {plot: scene, at: [0 s, 0.5 s], words: [first, then]}"}};
  return all;
}

/// Returns the example of a section. It is a whole file if it begins with `stepwire: 1`; else it replaces or
/// extends sections of the head's example.
std::string example_of(const std::string& section) {
  const auto found = examples().find(section);
  return found == examples().end() ? "" : found->second;
}

/// Returns the form of the head, completed by the available solvers.
yaml::Key whole_head() {
  yaml::Key head = diagram::head_form();
  for (yaml::Key& row : head.of) {
    if (row.name != "solver") continue;
    std::vector<yaml::Key::Word> solvers;
    for (const solve::SolverKind& kind : solve::solver_kinds()) solvers.push_back({kind.name, kind.doc});
    row = yaml::key(row.name, row.doc,
                    yaml::form::either({yaml::form::words(std::move(solvers)), row.of.back()}));
  }
  return head;
}

std::string doc_of(const std::string& name) {
  return diagram::head_form().find(name)->doc;
}

std::vector<Section> all_sections() {
  std::vector<Section> all{
      {"head", "", "what stands at the top of a diagram file", whole_head(), example_of("head")}};
  const auto add = [&](const std::string& name, const std::string& definition, const yaml::Key& form) {
    all.push_back({name, definition, doc_of(name), form, example_of(name)});
  };
  add("parameters", "parameter", diagram::parameter_form());
  add("inputs", "input", diagram::input_form());
  add("outputs", "output", diagram::output_form());
  add("record", "record", diagram::record_form());
  add("sweep", "sweep", diagram::sweep_form());
  add("figure", "", plot::figure_form());
  add("scene", "scene", scene::scene_form());
  add("claims", "claim", claim::claim_form());
  add("fit", "fit", estimation::fit_form());
  add("sensitivity", "sensitivity", sensitivity::sensitivity_form());
  add("tune", "tune", tuning::tune_form());
  add("linear", "linear", linear::linear_form());
  add("trim", "trim", linear::trim_form());
  add("study", "study", study::study_form());
  for (const yaml::Key& plot : plot::plot_forms(true))
    all.push_back({"figure." + plot.name, "", plot.doc, plot, example_of("figure." + plot.name)});
  return all;
}

}  // namespace

const std::vector<Section>& format_sections() {
  static const std::vector<Section> sections = all_sections();
  return sections;
}

const Section* find_section(const std::string& name) {
  const auto found = std::ranges::find_if(format_sections(), [&](const Section& section) {
    return section.name == name || (!name.empty() && section.definition == name);
  });
  return found == format_sections().end() ? nullptr : &*found;
}

}  // namespace stepwire::reference
