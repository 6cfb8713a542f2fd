#include "engine/app/reference/sections.hpp"

#include <algorithm>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/analyse/sensitivity/sensitivity.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/app/reference/section_examples.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/simulate/solve/solver.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::reference {

namespace {

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
