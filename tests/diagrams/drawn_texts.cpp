#include "tests/diagrams/drawn_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <set>

namespace stepwire {

namespace {

using Words = std::vector<std::string>;

/// Units of the quantity that a word names; an empty list: any unit, and none: an axis of words.
const std::map<std::string, Words>& quantities() {
  static const Words length{"m"}, force{"N"}, angle{"rad"}, speed{"m/s", "rad/s"}, any{};
  static const std::map<std::string, Words> all{{"time", {"s"}},
                                                {"force", force},
                                                {"resistance", force},
                                                {"F_max", force},
                                                {"torque", {"N m"}},
                                                {"current", {"A"}},
                                                {"command", {"A"}},
                                                {"work", {"J"}},
                                                {"energy", {"J"}},
                                                {"x", length},
                                                {"y", length},
                                                {"z", length},
                                                {"X", length},
                                                {"Y", length},
                                                {"position", length},
                                                {"distance", length},
                                                {"displacement", length},
                                                {"length", length},
                                                {"way", length},
                                                {"Er", length},
                                                {"speed", speed},
                                                {"velocity", speed},
                                                {"angle", angle},
                                                {"direction", angle},
                                                {"azimuth", angle},
                                                {"elevation", angle},
                                                {"ray", angle},
                                                {"ratio", {"1"}},
                                                {"normalised", {"1"}},
                                                {"mean", {"1"}},
                                                {"error", any},
                                                {"rate", any},
                                                {"feedback", {"none"}}};
  return all;
}

/// Number of the component that a word of a label names; 0: none.
int component_of(const std::string& word) {
  static const std::map<std::string, int> all{{"x", 1},      {"X", 1},          {"F_x", 1},
                                              {"radial", 1}, {"y", 2},          {"Y", 2},
                                              {"F_y", 2},    {"tangential", 2}, {"z", 3}};
  const auto found = all.find(word);
  return found == all.end() ? 0 : found->second;
}

Words matches(const std::string& text, const std::string& pattern, std::size_t group = 0) {
  const std::regex regex(pattern);
  Words found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.push_back(at->str(group));
  return found;
}

Words words_of(const std::string& text) {
  return matches(text, "[A-Za-z_][A-Za-z0-9_]*");
}

/// The first word of a label that names a quantity.
const Words* units_of_label(const std::string& label) {
  for (const std::string& word : words_of(label))
    if (const auto found = quantities().find(word); found != quantities().end()) return &found->second;
  return nullptr;
}

/// The components of vectors that a formula names; the number of a link, as in rig.length.2, is none.
std::set<int> components_in(const std::string& formula) {
  static const std::set<std::string> of_links{"length", "rate", "current"};
  std::set<int> found;
  const Words vectors = matches(formula, R"(([A-Za-z_]\w*)\.(\d+)\b)", 1);
  const Words numbers = matches(formula, R"(([A-Za-z_]\w*)\.(\d+)\b)", 2);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    if (!of_links.contains(vectors[i])) found.insert(std::stoi(numbers[i]));
  for (const std::string& name : matches(formula, R"((?:^|[^\w.])(?:[A-Za-z_]\w*\.)*([xyz])(?![\w.]))", 1))
    found.insert(component_of(name));
  return found;
}

/// The words that a condition selects: of `edition == "literature D1"` these two.
Words selected_in(const std::string& where) {
  return matches(where, R"(== "([^"]*)\")", 1);
}

/// A panel with the titles above it.
class PanelTexts {
 public:
  PanelTexts(const plot::Panel& panel, const std::string& picture_title, const std::string& place)
      : panel_(panel), titles_(picture_title + ", " + panel.title), place_(place) {
    if (panel.where) where_ = panel.where->text;
    signals_ = where_;
    for (const auto& [key, rows] : panel.series) signals_ += " " + text_of(rows);
  }

  /// Words that all panels of the file select are in no title.
  Words faults(const Words& alike) {
    for (const char* axis : {"x", "y", "z", "color"}) {
      const std::string& label = panel_.axis(axis).label;
      if (label.empty()) continue;
      check_unit(axis, label);
      check_components(axis, label);
      check_opposites(label, rows_of(axis) ? text_of(*rows_of(axis)) : signals_);
    }
    if (!panel_.title.empty()) {
      check_opposites(panel_.title, signals_);
      check_needs();
      check_selected_words(alike);
    }
    return std::move(faults_);
  }

 private:
  template <class... Arguments>
  void fault(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    faults_.push_back(place_ + ": " + fmt::format(format, std::forward<Arguments>(arguments)...));
  }

  static std::string text_of(const std::vector<query::Series>& rows) {
    std::string text;
    for (const query::Series& row : rows) text += " " + row.formula.text;
    return text;
  }

  const std::vector<query::Series>* rows_of(const std::string& axis) const {
    const auto found = panel_.series.find(axis);
    return found == panel_.series.end() ? nullptr : &found->second;
  }

  void check_unit(const std::string& axis, const std::string& label) {
    const Words* units = units_of_label(label);
    const auto* rows = rows_of(axis);
    if (axis == "color" && !rows) rows = rows_of("u");  // arrows are coloured by their length
    if (!units || units->empty()) return;
    const bool none = units->front() == "none";
    if (none != !rows)
      return fault("'{}' is the label of {}", label, rows ? "a quantity" : "an axis of words");
    if (none) return;
    const auto unit = unit::parse_unit(rows->front().unit_text);
    const auto agrees = [&](const std::string& text) {
      const auto wanted = unit::parse_unit(text);
      return unit->dimension == wanted->dimension && unit->dimension.angle == wanted->dimension.angle;
    };
    if (!unit || std::ranges::none_of(*units, agrees))
      fault("'{}' is drawn in '{}'", label, rows->front().unit_text);
  }

  void check_components(const std::string& axis, const std::string& label) {
    const auto* rows = rows_of(axis);
    if (!rows) return;
    for (const std::string& word : words_of(label)) {
      const int component = component_of(word);
      if (component == 0) continue;
      bool named = false, other = false;
      for (const query::Series& row : *rows) {
        const std::set<int> found = components_in(row.formula.text);
        named = named || found.contains(component);
        other = other || (!found.empty() && !found.contains(component));
      }
      if (other || (!named && label == word)) fault("'{}' is drawn as {}", rows->front().formula.text, label);
    }
  }

  /// A text with one of two opposites must not be beside signals with the other one alone.
  void check_opposites(const std::string& text, const std::string& signals) {
    static constexpr std::array<std::array<const char*, 2>, 5> opposites{{{"first", "second"},
                                                                          {"line", "sin"},
                                                                          {"left", "right"},
                                                                          {"forward", "return"},
                                                                          {"azimuth", "elevation"}}};
    const auto has = [](const std::string& in, const std::string& begin) {
      return std::regex_search(in, std::regex("\\b" + begin));
    };
    for (const auto& pair : opposites)
      for (const auto& [one, other] : {std::pair(pair[0], pair[1]), std::pair(pair[1], pair[0])})
        if (has(text, one) && !has(text, other) && has(signals, other) && !has(signals, one))
          fault("'{}' is the text of signals of the {}", text, other);
  }

  /// Words of titles that are wrong without these parts of signals.
  void check_needs() {
    static constexpr std::array<std::array<const char*, 2>, 3> needs{
        {{"means of all", "mean."}, {"^Ratios", "/"}, {"as printed$", "raw"}}};
    for (const auto& [words, signal] : needs)
      if (std::regex_search(titles_, std::regex(words)) && signals_.find(signal) == std::string::npos)
        fault("'{}' is the title of '{}'", titles_, signals_);
  }

  void check_selected_words(const Words& alike) {
    for (const std::string& selected : selected_in(where_)) {
      if (std::ranges::find(alike, selected) != alike.end()) continue;
      const auto missing = [&](const std::string& word) {
        const std::regex whole("(^|[^A-Za-z0-9])" + word + "($|[^A-Za-z0-9])", std::regex::icase);
        return !std::regex_search(titles_, whole);
      };
      if (std::ranges::any_of(matches(std::regex_replace(selected, std::regex(" deg"), "°"), R"(\S+)"),
                              missing))
        fault("rows of '{}' are under the titles '{}'", selected, titles_);
    }
  }

  const plot::Panel& panel_;
  std::string titles_, place_, where_, signals_;
  Words faults_;
};

/// Numbers that a file contains, in SI.
class FileNumbers {
 public:
  explicit FileNumbers(const session::LoadedModel& model) {
    for (const diagram::DiagramParameter& parameter : model.job.plan.diagram.parameters)
      if (const double* number = std::get_if<double>(&parameter.value.content)) numbers_.push_back(*number);
    if (const auto& sweep = model.job.plan.diagram.sweep)
      for (const diagram::Sweep::Axis& axis : sweep->axes) add(axis);
    for (const plot::Figure& figure : model.figures)
      for (const plot::Panel& panel : figure.panels)
        if (panel.where) add_quantities(panel.where->text);
  }

  bool contains(double number) const {
    return std::ranges::any_of(numbers_,
                               [&](double one) { return std::abs(one - number) <= 1e-9 * std::abs(number); });
  }

 private:
  void add(const diagram::Sweep::Axis& axis) {
    numbers_.push_back(static_cast<double>(axis.count()));
    for (std::size_t i = 0; i < axis.count(); ++i)
      if (const auto quantity = unit::parse_quantity(axis.text(i))) numbers_.push_back(quantity->value);
  }
  void add_quantities(const std::string& text) {
    for (const std::string& one : matches(text, R"([0-9.]+( [A-Za-z]+\b)?)"))
      if (const auto quantity = unit::parse_quantity(one)) numbers_.push_back(quantity->value);
  }

  std::vector<double> numbers_;
};

/// The numbers of a title in SI. The unit of the last one of a list is that of all. "1-D" and the numbers of
/// named things, as "table 1", are none.
std::vector<double> numbers_in(const std::string& title) {
  const std::string unnamed = std::regex_replace(
      title,
      std::regex(R"(\b(map|table|layer|task|figure|subject|equation|[A-Z]) ?\d+|\d+-[A-Z])",
                 std::regex::icase),
      "");
  const std::string list = R"((\d+(?:\.\d+)?(?:(?:, | and )\d+(?:\.\d+)?)*) ?(pi rad|°|[A-Za-z/]+)?)";
  std::vector<double> numbers;
  const Words lists = matches(unnamed, list, 1), units = matches(unnamed, list, 2);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const bool half_turns = units[i] == "pi rad";
    const auto unit = unit::parse_unit(half_turns ? "rad" : units[i] == "°" ? "deg" : units[i]);
    for (const std::string& number : matches(lists[i], R"(\d+(?:\.\d+)?)"))
      numbers.push_back((unit ? unit->to_si(std::stod(number)) : std::stod(number)) *
                        (half_turns ? M_PI : 1.0));
  }
  return numbers;
}

void check_numbers(const std::string& title, const std::string& place, const FileNumbers& numbers,
                   Words& faults) {
  for (const double number : numbers_in(title))
    if (!numbers.contains(number))
      faults.push_back(fmt::format("{}: nothing in the file is {} in SI, as in '{}'", place, number, title));
}

/// The words that the conditions of all panels select.
Words selected_by_all(const session::LoadedModel& model) {
  std::map<std::string, std::size_t> counts;
  std::size_t panels = 0;
  for (const plot::Figure& figure : model.figures)
    for (const plot::Panel& panel : figure.panels) {
      ++panels;
      if (panel.where)
        for (const std::string& selected : selected_in(panel.where->text)) ++counts[selected];
    }
  Words alike;
  for (const auto& [selected, count] : counts)
    if (count == panels) alike.push_back(selected);
  return alike;
}

template <class Check>
void for_every_panel(const session::LoadedModel& model, Check check) {
  for (std::size_t i = 0; i < model.figures.size(); ++i)
    for (std::size_t k = 0; k < model.figures[i].panels.size(); ++k)
      check(model.figures[i], model.figures[i].panels[k], fmt::format("figure.{}.{}", i + 1, k + 1));
}

}  // namespace

std::vector<std::string> text_faults(const session::LoadedModel& model) {
  Words faults;
  const FileNumbers numbers(model);
  const Words alike = selected_by_all(model);
  for_every_panel(model, [&](const plot::Figure& figure, const plot::Panel& panel, const std::string& place) {
    std::ranges::move(PanelTexts(panel, figure.title, place).faults(alike), std::back_inserter(faults));
    check_numbers(panel.title, place, numbers, faults);
  });
  for (const plot::Figure& figure : model.figures) check_numbers(figure.title, "title", numbers, faults);
  return faults;
}

std::vector<std::string> unknown_labels(const session::LoadedModel& model) {
  Words unknown;
  for_every_panel(model, [&](const plot::Figure&, const plot::Panel& panel, const std::string& place) {
    for (const char* axis : {"x", "y", "z", "color"})
      if (const std::string& label = panel.axis(axis).label; !label.empty() && !units_of_label(label))
        unknown.push_back(place + ": " + label);
  });
  return unknown;
}

}  // namespace stepwire
