// Keys of a sweep.
#include "engine/model/diagram/head_distribution.hpp"
#include "engine/model/diagram/head_keys.hpp"

namespace stepwire::diagram {

using yaml::form;

namespace {

yaml::Key spread(const char* name, const char* doc, const char* example, double numbers) {
  return yaml::one_of(
      "distribution",
      yaml::key(name, doc, yaml::like(example, form::list(form::number(), numbers, numbers))));
}

yaml::Key correlation_row() {
  return yaml::key(
      "correlation",
      "how drawn numbers go together (Gaussian copula): pairs, {k: {m: 0.5}}, or a matrix of all "
      "that are drawn, in their order",
      form::either({form::naming(yaml::Key::Names::parameter, form::names(form::names(form::number()))),
                    form::list(form::list(form::number(), 1), 1)}));
}

yaml::Key axis_form() {
  const yaml::Key values = form::list(form::text(), 1);
  return form::either({values,
                       form::keys("an axis", "{values: [1, 2]}",
                                  {yaml::needed(yaml::key("values", "in this order", values))}),
                       range_form(), distribution_form()});
}

yaml::Key together_row() {
  return yaml::otherwise(
      "false",
      yaml::key("together", "true: the parameters are paired, else they make a grid", form::truth()));
}

yaml::Key one_at_a_time_row() {
  return yaml::key(
      "one_at_a_time",
      "parameters of which one at a time leaves the file's value: {mass: [1 kg, 3 kg]}; the columns differs "
      "and differs_to say which and to what",
      yaml::like("{mass: [1 kg, 3 kg], drive: [1 Hz, 2 Hz]}",
                 form::naming(yaml::Key::Names::parameter, form::names(axis_form(), 1))));
}

yaml::Key cases_row() {
  return yaml::key(
      "cases",
      "all other values are run in each of these cases, with what it sets: {off: {}, on: {current: 1 A}}; a "
      "kept number `x` has the names off.x and on.x in a row for both",
      yaml::like("{light: {}, heavy: {mass: 3 kg}}",
                 form::names(form::naming(yaml::Key::Names::parameter, form::names(form::text())), 2,
                             "^[A-Za-z_][A-Za-z0-9_]*$")));
}

yaml::Key keep_row() {
  return yaml::otherwise(
      "rows", yaml::key("keep",
                        "what stays of each run: its rows, or one row, which is its last one or has "
                        "reductions with a name: {peak: max(x), overshoot: overshoot(x)}",
                        form::either({keep_word_form(), form::names(form::expression(), 1)})));
}

}  // namespace

const yaml::Key& keep_word_form() {
  static const yaml::Key form =
      form::words({{"rows", "all that is recorded"}, {"final", "the last recorded row"}});
  return form;
}

const yaml::Key& distribution_form() {
  static const yaml::Key form = form::keys(
      "a distribution", "{uniform: [100 N/m, 300 N/m]}",
      {spread("uniform", "even between two bounds: [low, high]", "[100 N/m, 300 N/m]", 2),
       spread("normal", "[mean, standard deviation]", "[20 mm, 0.5 mm]", 2),
       spread("lognormal", "[median, coefficient of variation]: standard deviation over mean", "[2 kg, 0.2]",
              2),
       spread("triangular", "[low, mode, high]", "[1 s, 2 s, 4 s]", 3),
       yaml::one_of(
           "distribution",
           yaml::key("words", "words and their weights",
                     yaml::like("{ice: 1, road: 3}", form::names(form::above_zero(form::number()), 2))))});
  return form;
}

const yaml::KeyTable<sampling::Design, HeadReading>& design_table() {
  static const yaml::KeyTable<sampling::Design, HeadReading> table(
      "a design", "{samples: 1000, kind: sobol, seed: 3}",
      {yaml::needed(yaml::KeyRow<sampling::Design, HeadReading>{"samples", "how many samples are drawn",
                                                                form::whole(1, static_cast<double>(max_runs)),
                                                                &sampling::Design::samples}),
       {"kind", "how they are laid out",
        form::words({{"random", "each point alone"},
                     {"latin_hypercube",
                      "as many layers of equal probability along each parameter as there "
                      "are points, one point in each"},
                     {"sobol", "low discrepancy: scrambled Sobol points"},
                     {"saltelli",
                      "for the indices of Sobol: a sample is as many runs as there are parameters, "
                      "and two more"},
                     {"morris",
                      "for a screening: a sample is as many runs as there are parameters, and one "
                      "more"}}),
        &sampling::Design::layout},
       {"seed", "another whole number draws other points", form::whole(0, 9e15), &sampling::Design::seed}});
  return table;
}

const yaml::KeyTable<Sweep, HeadReading>& recorded_runs_table() {
  static const yaml::KeyTable<Sweep, HeadReading> table(
      "runs whose rows stay", "{runs: 20}",
      {yaml::needed(yaml::KeyRow<Sweep, HeadReading>{
          "runs", "how many, of each case; they are evenly chosen, the first and the last one among them",
          form::whole(1, static_cast<double>(max_runs)), &Sweep::recorded_runs})});
  return table;
}

const yaml::Key& range_form() {
  static const yaml::Key form =
      form::keys("a range", "{from: 1 N, to: 9 N, count: 5}",
                 {yaml::needed(yaml::key("from", "the first value", form::number())),
                  yaml::needed(yaml::key("to", "the last", form::number())),
                  yaml::needed(yaml::key("count", "how many values, both ends included", form::whole(2)))});
  return form;
}

const yaml::Key& sweep_form() {
  static const yaml::Key form = [] {
    yaml::Key sweep =
        form::keys("a sweep", "{ratio: [0.1, 0.2], drive: {from: 1 Hz, to: 2 Hz, count: 5}}",
                   {together_row(), one_at_a_time_row(),
                    yaml::key("design",
                              "how often and where values are drawn that have a "
                              "distribution",
                              design_table().form),
                    correlation_row(), cases_row(), keep_row(),
                    yaml::key("record", "beside numbers that are kept: of how many runs the rows stay, too",
                              recorded_runs_table().form)});
    sweep.rest = {yaml::key("NAME", "the values of a parameter, step or solver", axis_form())};
    sweep.rest.front().names = yaml::Key::Names::parameter;
    return sweep;
  }();
  return form;
}

}  // namespace stepwire::diagram
