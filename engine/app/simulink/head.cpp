#include "engine/app/simulink/head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {

namespace {

/// A solver of Simulink, and the one here.
struct Solver {
  const char* name;
  bool controls_error;
  const char* difference = "";  ///< sentence of the report; empty: the same method
};

const std::map<std::string, Solver>& solvers() {
  static const std::map<std::string, Solver> all{
      {"ode1", {"euler", false}},
      {"ode2", {"heun", false}},
      {"ode3", {"bogacki_shampine", false}},
      {"ode4", {"rk4", false}},
      {"ode5", {"dormand_prince", false}},
      {"ode8", {"dop853", true, "ode8 has fixed steps in Simulink; dop853 controls its error here"}},
      {"ode14x", {"sdirk", false, "ode14x extrapolates in Simulink; sdirk is the implicit method here"}},
      {"ode1be", {"sdirk", false, "ode1be is of order 1 in Simulink; sdirk is the implicit method here"}},
      {"FixedStepAuto",
       {"bogacki_shampine", false, "the solver is chosen by Simulink; bogacki_shampine (ode3) is written"}},
      {"ode45", {"dormand_prince", true}},
      {"ode23", {"bogacki_shampine", true}},
      {"ode113", {"dop853", true, "ode113 is a multistep method; dop853 is written"}},
      {"ode15s", {"radau", true, "ode15s is a multistep method for stiff models; radau is written"}},
      {"ode23s", {"rosenbrock", true}},
      {"ode23t", {"radau", true, "ode23t is written as radau, also for stiff models"}},
      {"ode23tb", {"radau", true, "ode23tb is written as radau, also for stiff models"}},
      {"daessc", {"radau", true, "daessc is for physical networks; radau is written"}},
      {"VariableStepAuto", {"auto", true}}};
  return all;
}

std::string setting(const FlatModel& of, const std::string& name, const std::string& otherwise) {
  const Texts& texts = of.model().solver;
  const auto found = texts.find(name);
  if (found != texts.end()) return found->second;
  const Texts& old = of.model().texts;  // models of R2012 have some of them here
  const auto own = old.find(name);
  return own == old.end() ? otherwise : own->second;
}

/// Returns the number of a setting; NaN for "auto".
double number_of(FlatModel& model, const std::string& name, const std::string& otherwise,
                 std::vector<Note>& notes) {
  const std::string text = setting(model, name, otherwise);
  if (text == "auto" || text == "-1") return std::nan("");
  try {
    return model.evaluate(model.root(), text).number();
  } catch (const ValueError& error) {
    notes.push_back({NoteKind::missing, "",
                     fmt::format("its {}, '{}', {}; {} is written", name, text, error.what(), otherwise)});
    return otherwise == "auto" ? std::nan("") : std::atof(otherwise.c_str());
  }
}

/// Returns the smallest n of 1, 2, 5, 10, 20, 50, ... that is not below a number.
double round_count(double least) {
  double n = 1.0;
  for (int i = 0; n < least * (1.0 - 1e-9) && i < 60; ++i) n *= i % 3 == 1 ? 2.5 : 2.0;
  return n;
}

/// Returns the greatest common divisor of times, to the nanosecond; 0 without times.
double common_period(const std::vector<double>& times) {
  long long common = 0;
  for (const double time : times) common = std::gcd(common, std::llround(std::min(time, 9e9) * 1e9));
  return static_cast<double>(common) / 1e9;
}

void read_solver(FlatModel& model, Head& head, std::vector<Note>& notes) {
  const std::string name = setting(model, "Solver", setting(model, "SolverName", "ode45"));
  if (name == "FixedStepDiscrete" || name == "VariableStepDiscrete") {
    head.is_fixed = name == "FixedStepDiscrete";
    return;
  }
  const auto found = solvers().find(name);
  if (found == solvers().end())
    notes.push_back({NoteKind::differs, "", fmt::format("the solver {} is written as auto", name)});
  const Solver solver = found == solvers().end() ? Solver{"auto", true} : found->second;
  if (solver.difference[0] != '\0') notes.push_back({NoteKind::differs, "", solver.difference});
  head.is_fixed = !solver.controls_error || name == "ode8";
  if (!solver.controls_error) {
    head.solver = word(solver.name);
    return;
  }
  const double relative = number_of(model, "RelTol", "1e-3", notes),
               absolute = number_of(model, "AbsTol", "auto", notes);
  const auto text = [](double value, const char* otherwise) {
    return word(std::isnan(value) ? otherwise : fmt::format("{}", value));
  };
  head.solver = map_of({{"name", word(solver.name)},
                        {"relative", text(relative, "1e-3")},
                        {"absolute", text(absolute, "1e-6")}});
  head.locates_events = setting(model, "ZeroCrossControl", "UseLocalSettings") != "DisableAll";
}

}  // namespace

Head read_head(FlatModel& model, std::vector<Note>& notes) {
  Head head;
  read_solver(model, head, notes);
  const double start = number_of(model, "StartTime", "0", notes);
  if (start != 0.0)
    notes.push_back(
        {NoteKind::deviates, "", fmt::format("begins at {} s in Simulink, and at 0 here", start)});
  if (setting(model, "LoadInitialState", "off") == "on")
    notes.push_back({NoteKind::deviates, "",
                     fmt::format("begins with the states of '{}' in Simulink, and with the initial values of "
                                 "its blocks here",
                                 on_one_line(setting(model, "InitialState", "xInitial")))});
  head.stop = number_of(model, "StopTime", "10", notes);
  if (!std::isfinite(head.stop) || head.stop <= 0.0) {
    notes.push_back({NoteKind::deviates, "",
                     fmt::format("has the stop time {}; 10 s is written", setting(model, "StopTime", "10"))});
    head.stop = 10.0;
  }
  const double given = number_of(model, head.is_fixed ? "FixedStep" : "MaxStep", "auto", notes);
  const bool has_step = std::isfinite(given) && given > 0.0;
  head.step = has_step ? given : head.stop / (head.is_fixed ? 50.0 : 1000.0);
  head.is_fixed = head.is_fixed && has_step;
  head.solves_loops = setting(model, "AlgebraicLoopMsg", "warning") != "error";
  return head;
}

void fit_step(Head& head, const Collected& collected, std::vector<Note>& notes) {
  double base = common_period(collected.periods);
  if (!collected.periods.empty()) {
    const double least = std::ranges::min(collected.periods);
    if (base < least / 1000.0) {
      notes.push_back(
          {NoteKind::fault, "", "its sample times have no common step; give 'step' one that fits"});
      base = least;
    }
  }
  if (!head.is_fixed && collected.shortest < head.step)
    head.step = head.stop / round_count(head.stop / collected.shortest);
  const double most = head.step;
  if (!head.is_fixed && base > 0.0) head.step = collected.has_states ? base / round_count(base / most) : base;
  const double count = head.stop / head.step;
  if (std::abs(count - std::round(count)) < 1e-6 * std::max(1.0, count)) return;
  const double stop = std::ceil(count) * head.step;
  notes.push_back({NoteKind::differs, "",
                   fmt::format("its stop time {} s is no whole number of steps of {} s; {} s is written",
                               head.stop, head.step, stop)});
  head.stop = stop;
}

}  // namespace stepwire::simulink
