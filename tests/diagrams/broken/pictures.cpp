#include "tests/diagrams/broken/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <ranges>
#include <span>

#include "engine/analyse/kept/names.hpp"
#include "tests/diagrams/broken/signals.hpp"

namespace stepwire::broken {

namespace {

using yaml::Node;

Node* value_of(Node& map, std::string_view key) {
  const auto found = std::ranges::find(map.entries, key, &yaml::Entry::key);
  return found == map.entries.end() ? nullptr : &found->value;
}

std::span<Node> rows_of(Node& value) {
  return value.is_list() ? std::span<Node>(value.items) : std::span<Node>(&value, 1);
}

/// The scalar of an expression and its unit, also where it has a label.
Node& signal_in(Node& row) {
  Node* signal = row.is_map() ? value_of(row, "signal") : nullptr;
  return signal ? *signal : row;
}

/// The same unit behind another expression.
void put(Node& row, const std::string& expression) {
  Node& signal = signal_in(row);
  const std::size_t in = signal.text.rfind(" in ");
  signal.text = expression + (in == std::string::npos ? "" : signal.text.substr(in));
}

/// One panel of a section, in which it is changed.
class PanelChanges {
 public:
  PanelChanges(const Node& section, std::size_t picture, std::size_t panel,
               std::vector<PictureChange>& changes)
      : section_(section), picture_(picture), panel_(panel), changes_(changes) {
    const Node* panels = section.as_list()[picture].find("panels");
    place_ = fmt::format("figure.{}", picture + 1);
    if (panels && panels->items.size() > 1) place_ += fmt::format(".{}", panel + 1);
  }

  Node* find(std::string_view key) { return value_of(panel_of(section_), key); }

  /// The section after a change of its panel.
  template <class Change>
  ChangedSection section(Change change, std::string with = {}) const {
    ChangedSection changed{section_, std::move(with)};
    change(panel_of(changed.figure));
    return changed;
  }
  template <class Change>
  void add(const std::string& what, Change change) {
    add(what, std::vector{section(change)});
  }
  void add(const std::string& what, std::vector<ChangedSection> sections, bool of_text = false) {
    if (!sections.empty()) changes_.push_back({place_ + what, picture_, std::move(sections), of_text});
  }

 private:
  Node& panel_of(Node& section) const {
    Node& picture = rows_of(section)[picture_];
    Node* panels = value_of(picture, "panels");
    return panels ? rows_of(*panels)[panel_] : picture;
  }

  Node section_;
  std::size_t picture_, panel_;
  std::string place_;
  std::vector<PictureChange>& changes_;
};

void rename(Node& map, const std::string& from, const std::string& to) {
  for (yaml::Entry& entry : map.entries)
    entry.key = entry.key == from ? to : entry.key == to ? from : entry.key;
}

/// Rows, ranges and points with their axes exchanged.
void exchange_axes(Node& panel) {
  const std::size_t count = rows_of(*value_of(panel, "y")).size();
  Node& x = *value_of(panel, "x");
  if (!x.is_list() && count > 1) x = {Node::Kind::list, false, x.mark, x.end, {}, std::vector(count, x), {}};
  rename(panel, "x", "y");
  rename(panel, "x_range", "y_range");
  for (const char* key : {"marks", "texts"})
    if (Node* points = value_of(panel, key)) {
      for (yaml::Entry& point : points->entries) std::swap(point.value.items.at(0), point.value.items.at(1));
      for (Node& point : points->items) std::swap(point.items.at(0), point.items.at(1));
    }
}

void add_exchanged_axes(const plot::Panel& panel, PanelChanges& changes) {
  if (!panel.find("x") || !panel.find("y")) return;
  changes.add(".x and .y exchanged", exchange_axes);
  const auto &x = panel.series.at("x"), &y = panel.series.at("y");
  for (std::size_t row = 0; x.size() == y.size() && x.size() > 1 && row < x.size(); ++row)
    if (x[row].formula.dimension == y[row].formula.dimension)
      changes.add(fmt::format(".x.{0} and .y.{0} exchanged", row + 1), [row](Node& node) {
        std::swap(rows_of(*value_of(node, "x"))[row], rows_of(*value_of(node, "y"))[row]);
      });
}

/// The rows of a channel, or of a motion or a rose: negated and replaced.
struct Row {
  std::string name;
  const query::Formula& formula;
  std::function<Node&(Node& panel)> in;
};

void add_row(const Row& row, const std::vector<Signal>& signals, PanelChanges& changes) {
  changes.add(row.name + " negated", [&](Node& panel) { put(row.in(panel), "-(" + row.formula.text + ")"); });
  std::vector<ChangedSection> sections;
  for (const Signal& signal : instead_of(row.formula, signals) | std::views::take(4))
    sections.push_back(changes.section([&](Node& panel) { put(row.in(panel), signal.text); }, signal.text));
  changes.add(row.name + " replaced", std::move(sections));
}

void add_rows(const plot::Panel& panel, const std::vector<Signal>& signals, PanelChanges& changes) {
  for (const auto& [key, rows] : panel.series) {
    if (!is_drawn(key) || !changes.find(key)) continue;
    for (std::size_t i = 0; i < rows.size(); ++i)
      add_row({rows.size() > 1 ? fmt::format(".{}.{}", key, i + 1) : "." + key, rows[i].formula,
               [key = key, i](Node& node) -> Node& { return rows_of(*value_of(node, key))[i]; }},
              signals, changes);
  }
}

/// A channel of a motion or a rose.
Row row_over(const std::string& overlay, const std::string& channel, std::size_t i,
             const query::Series& series) {
  return {fmt::format(".{}.{}.{}", overlay, i + 1, channel), series.formula,
          [=](Node& node) -> Node& { return *value_of(rows_of(*value_of(node, overlay))[i], channel); }};
}

void add_overlays(const plot::Panel& panel, const std::vector<Signal>& signals, PanelChanges& changes) {
  for (std::size_t i = 0; i < panel.motions.size(); ++i) {
    add_row(row_over("motion", "x", i, panel.motions[i].x), signals, changes);
    add_row(row_over("motion", "y", i, panel.motions[i].y), signals, changes);
  }
  for (std::size_t i = 0; i < panel.roses.size(); ++i) {
    const plot::Rose& rose = panel.roses[i];
    add_row(row_over("rose", "x", i, rose.x), signals, changes);
    add_row(row_over("rose", "y", i, rose.y), signals, changes);
    add_row(row_over("rose", "angle", i, rose.angle), signals, changes);
    add_row(row_over("rose", "value", i, rose.value), signals, changes);
  }
}

/// Two texts that follow each other in a list, and two keys of a map.
void add_exchanged_texts(const std::string& key, std::size_t first, PanelChanges& changes) {
  const Node* node = changes.find(key);
  if (!node) return;
  for (std::size_t i = first; i + 1 < node->items.size(); ++i)
    changes.add(fmt::format(".{} {} and {} exchanged", key, i + 1, i + 2), [&](Node& panel) {
      Node& texts = *value_of(panel, key);
      std::swap(texts.items[i], texts.items[i + 1]);
    });
  for (std::size_t i = 0; i + 1 < node->entries.size(); ++i)
    changes.add(fmt::format(".{} {} and {} exchanged", key, i + 1, i + 2), [&](Node& panel) {
      Node& texts = *value_of(panel, key);
      std::swap(texts.entries[i].key, texts.entries[i + 1].key);
    });
}

void add_regions(const plot::Panel& panel, const query::SymbolTable& names, PanelChanges& changes) {
  if (panel.regions.size() != 1) return;
  std::vector<ChangedSection> sections;
  const auto begin =
      std::ranges::find(names.outlines, panel.regions.front().name, &query::NamedOutline::name);
  const auto take = [&](const query::NamedOutline& other) {
    if (other.name == begin->name) return;
    sections.push_back(
        changes.section([&](Node& node) { value_of(node, "region")->text = other.name; }, other.name));
  };
  std::for_each(begin, names.outlines.end(), take);
  std::for_each(names.outlines.begin(), begin, take);
  changes.add(".region replaced", std::move(sections));
}

/// Each cell and the next one in its row, and the one below it.
void add_exchanged_cells(PanelChanges& changes) {
  const Node* rows = changes.find("rows");
  if (!rows || !rows->is_map()) return;
  const auto exchange = [&](std::size_t row, std::size_t column, std::size_t below, std::size_t right) {
    if (row + below >= rows->entries.size()) return;
    if (column + right >= rows->entries[row + below].value.as_list().size()) return;
    changes.add(fmt::format(" cells {}.{} and {}.{} exchanged", row + 1, column + 1, row + below + 1,
                            column + right + 1),
                [&](Node& panel) {
                  auto& entries = value_of(panel, "rows")->entries;
                  std::swap(rows_of(entries[row].value)[column],
                            rows_of(entries[row + below].value)[column + right]);
                });
  };
  for (std::size_t row = 0; row < rows->entries.size(); ++row)
    for (std::size_t column = 0; column < rows->entries[row].value.as_list().size(); ++column) {
      exchange(row, column, 0, 1);
      exchange(row, column, 1, 0);
    }
}

/// Two labels of axes of the panel.
void add_exchanged_labels(PanelChanges& changes) {
  static const std::array labels{"x_label", "y_label", "z_label", "color_label"};
  for (auto one = labels.begin(); one != labels.end(); ++one)
    for (auto other = one + 1; other != labels.end(); ++other) {
      const Node *first = changes.find(*one), *second = changes.find(*other);
      if (!first || !second || first->text == second->text) continue;
      const auto exchange = [&](Node& panel) {
        std::swap(value_of(panel, *one)->text, value_of(panel, *other)->text);
      };
      changes.add(fmt::format(".{} and .{} exchanged", *one, *other), {changes.section(exchange)}, true);
    }
}

/// Titles of two neighbours in a list: of pictures or panels. `list` finds it in a section.
template <class List>
void add_exchanged_titles(const Node& section, std::size_t picture, const std::string& place, List list,
                          std::vector<PictureChange>& all) {
  Node changed = section;
  std::span<Node> rows = list(changed);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    Node *one = value_of(rows[i], "title"), *other = value_of(rows[i + 1], "title");
    if (!one || !other || one->text == other->text) continue;
    std::swap(one->text, other->text);
    all.push_back(
        {fmt::format("{} titles {} and {} exchanged", place, i + 1, i + 2), picture, {{changed}}, true});
    std::swap(one->text, other->text);
  }
}

void add_titles(const Node& section, std::vector<PictureChange>& all) {
  add_exchanged_titles(
      section, 0, "figure", [](Node& node) { return rows_of(node); }, all);
  for (std::size_t picture = 0; picture < section.as_list().size(); ++picture)
    add_exchanged_titles(
        section, picture, fmt::format("figure.{}", picture + 1),
        [&](Node& node) {
          Node* panels = value_of(rows_of(node)[picture], "panels");
          return panels ? rows_of(*panels) : std::span<Node>();
        },
        all);
}

void add_panel(const plot::Panel& panel, const query::SymbolTable& names, const std::vector<Signal>& signals,
               PanelChanges& changes) {
  add_exchanged_axes(panel, changes);
  add_rows(panel, signals, changes);
  add_overlays(panel, signals, changes);
  for (const char* key : {"legend", "marks", "texts"}) add_exchanged_texts(key, 0, changes);
  add_exchanged_texts("headings", 1, changes);
  if (panel.series.empty()) add_exchanged_texts("rows", 0, changes);
  add_exchanged_cells(changes);
  add_regions(panel, names, changes);
  add_exchanged_labels(changes);
}

}  // namespace

std::vector<PictureChange> picture_changes(const session::LoadedModel& model,
                                           const session::Outcome& outcome) {
  std::vector<PictureChange> all;
  const Node& section = model.job.plan.diagram.figure;
  const query::SymbolTable names = kept::names_of(model.job);
  const std::vector<Signal> signals = signals_of(model, outcome);
  for (std::size_t picture = 0; picture < model.figures.size(); ++picture)
    for (std::size_t panel = 0; panel < model.figures[picture].panels.size(); ++panel) {
      PanelChanges changes(section, picture, panel, all);
      add_panel(model.figures[picture].panels[panel], names, signals, changes);
    }
  add_titles(section, all);
  return all;
}

}  // namespace stepwire::broken
