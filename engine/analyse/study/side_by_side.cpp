#include "engine/analyse/study/side_by_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::study {

using json::Json;

namespace {

constexpr double factor_of_agreement = 2.0;

constexpr double unpublished = std::numeric_limits<double>::quiet_NaN();

std::string title_of(const std::string& what, const PublishedValues& published) {
  return published.values.empty() ? what : what + ": published (" + published.source + ") and ours";
}

/// Returns the names by falling value; equal values remain in order.
std::string order_of(std::vector<NamedValue> values) {
  std::stable_sort(values.begin(), values.end(),
                   [](const NamedValue& a, const NamedValue& b) { return a.value > b.value; });
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : values[i].value == values[i - 1].value ? " = " : " > ") + values[i].name;
  return text;
}

/// Returns the values of those conditions of a list that we have.
std::vector<NamedValue> present(const std::vector<std::string>& names, const std::vector<NamedValue>& ours) {
  std::vector<NamedValue> result;
  for (const std::string& name : names)
    if (const double value = value_of(ours, name); !std::isnan(value)) result.push_back({name, value});
  return result;
}

Agreement judge_order(const std::vector<NamedValue>& listed) {
  std::vector<std::string> names;
  bool falls = true;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    names.push_back(listed[i].name);
    falls = falls && (i == 0 || listed[i].value < listed[i - 1].value);
  }
  return {fmt::format("order {}", fmt::join(names, " > ")), falls, order_of(listed)};
}

/// Compares ratios to the condition with the largest published error; they do not depend on the
/// normalisation.
void judge_ratios(SideBySide& both) {
  const auto largest = std::max_element(
      both.values.begin(), both.values.end(),
      [](const ComparedValue& a, const ComparedValue& b) { return a.published < b.published; });
  if (largest == both.values.end() || std::isnan(largest->ours) || std::isnan(largest->published)) return;
  for (const ComparedValue& value : both.values) {
    if (&value == &*largest || std::isnan(value.ours)) continue;
    const double published = value.published / largest->published, ours = value.ours / largest->ours;
    const double apart = std::max(published / ours, ours / published);
    both.agreements.push_back(
        {fmt::format("{} is {:.3g} of {}, within a factor of two", value.name, published, largest->name),
         apart <= factor_of_agreement, fmt::format("{:.3g}", ours)});
  }
}

std::string word(double p) {
  return std::isnan(p) ? "cannot be estimated" : p < significant ? "significant" : "not significant";
}

/// Returns "lowers the error by 0.12"; empty for nan.
std::string direction(double effect) {
  if (std::isnan(effect)) return "";
  if (effect == 0.0) return "leaves the error as it is";
  return fmt::format("{} the error by {:.2g}", effect < 0.0 ? "lowers" : "raises", std::abs(effect));
}

/// Compares a factor. Significant effects must agree in sign; the sign of others is not compared.
Agreement judge_factor(const ComparedValue& p, const ComparedValue& effect) {
  const auto stated = [](double probability, double size) {
    const std::string which = direction(size);
    if (which.empty()) return word(probability);
    return probability < significant ? fmt::format("{} and {}", word(probability), which)
                                     : fmt::format("{} ({})", word(probability), which);
  };
  const bool known = !std::isnan(effect.published) && !std::isnan(effect.ours);
  const bool opposite = known && p.published < significant && effect.published * effect.ours <= 0.0;
  const std::string thesis = p.published < significant && !std::isnan(effect.published)
                                 ? fmt::format(" and {}", direction(effect.published))
                                 : "";
  return {fmt::format("{} is {} at {}{}", p.name, word(p.published), significant, thesis),
          word(p.ours) == word(p.published) && !opposite, stated(p.ours, effect.ours)};
}

std::string verdict(const Agreement& agreement) {
  return fmt::format("{}: {}; ours: {}.", agreement.agrees ? "Agrees" : "Disagrees", agreement.that,
                     agreement.ours);
}

}  // namespace

std::vector<Agreement> judge_orders(const std::vector<std::vector<std::string>>& order,
                                    const std::vector<NamedValue>& ours) {
  std::vector<Agreement> agreements;
  for (const auto& names : order)
    if (const auto listed = present(names, ours); listed.size() > 1)
      agreements.push_back(judge_order(listed));
  return agreements;
}

SideBySide compare_errors(const PublishedValues& published, const std::vector<NamedValue>& ours,
                          const std::vector<std::vector<std::string>>& order) {
  SideBySide both{title_of("Errors", published), "normalised error", {}, {}};
  for (const NamedValue& value : published.values)
    both.values.push_back({value.name, value.value, value_of(ours, value.name)});
  for (const NamedValue& value : ours)
    if (published.values.empty()) both.values.push_back({value.name, unpublished, value.value});
  both.agreements = judge_orders(order, ours);
  judge_ratios(both);
  return both;
}

SideBySide compare_significance(const PublishedStudy& published, const TaskAnalysis& ours,
                                const std::vector<Condition>& conditions) {
  SideBySide both{title_of("Significance", published.probabilities), "P", {}, {}};
  const auto effects = factor_effects(published.means.values, conditions);
  for (const NamedValue& value : published.probabilities.values) {
    const statistics::AnovaRow* row = ours.additive.find(value.name);
    const double p = row == nullptr ? std::numeric_limits<double>::quiet_NaN() : row->p;
    both.values.push_back({value.name, value.value, p});
    both.effects.push_back({value.name, value_of(effects, value.name), value_of(ours.effects, value.name)});
    both.agreements.push_back(judge_factor(both.values.back(), both.effects.back()));
  }
  if (!published.probabilities.values.empty()) return both;
  for (const NamedValue& effect : ours.effects) {
    const statistics::AnovaRow* row = ours.additive.find(effect.name);
    both.values.push_back({effect.name, unpublished, row ? row->p : unpublished});
    both.effects.push_back({effect.name, unpublished, effect.value});
  }
  return both;
}

namespace {

/// Adds the columns of the signed effects.
void add_effects(const std::vector<ComparedValue>& effects, text::TextTable& table) {
  table.columns.insert(table.columns.end(), {"effect, published", "effect, ours"});
  const auto shown = [](double effect) { return std::isnan(effect) ? "–" : fmt::format("{:+.3f}", effect); };
  for (std::size_t i = 0; i < effects.size(); ++i)
    for (const double effect : {effects[i].published, effects[i].ours})
      table.rows[i].push_back(shown(effect));
  table.notes.push_back("Effect: what a factor adds to the mean normalised error; below 0 it helps.");
}

Json values_json(const std::vector<ComparedValue>& compared) {
  Json values = Json::list();
  for (const ComparedValue& value : compared)
    values.push(
        Json::object().set("name", value.name).set("published", value.published).set("ours", value.ours));
  return values;
}

}  // namespace

std::vector<SideBySide> compare(const PublishedStudy& published, const TaskAnalysis& ours,
                                const std::vector<Condition>& conditions) {
  return {compare_errors(published.means, ours.means, published.order),
          compare_significance(published, ours, conditions)};
}

text::TextTable side_by_side_table(const SideBySide& both) {
  text::TextTable table{both.title, {both.quantity, "published", "ours", "ours / published"}, {}, {}};
  for (const ComparedValue& value : both.values)
    table.rows.push_back({value.name, printed_probability(value.published), printed_probability(value.ours),
                          printed_probability(value.ours / value.published)});
  if (!both.effects.empty()) add_effects(both.effects, table);
  for (const Agreement& agreement : both.agreements) table.notes.push_back(verdict(agreement));
  return table;
}

Json side_by_side_json(const SideBySide& both) {
  Json values = values_json(both.values), agreements = Json::list();
  for (const Agreement& agreement : both.agreements)
    agreements.push(Json::object()
                        .set("that", agreement.that)
                        .set("agrees", agreement.agrees)
                        .set("ours", agreement.ours));
  Json json = Json::object()
                  .set("title", both.title)
                  .set("quantity", both.quantity)
                  .set("values", std::move(values))
                  .set("agreements", std::move(agreements));
  if (!both.effects.empty()) json.set("effects", values_json(both.effects));
  return json;
}

}  // namespace stepwire::study
