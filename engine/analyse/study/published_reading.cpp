#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/study/published_reading.hpp"

namespace stepwire::study {

using yaml::form;

namespace {

using ValuesTable = yaml::KeyTable<PublishedValues, StudyReading>;
using PublishedTable = yaml::KeyTable<PublishedStudy, StudyReading>;

void read_values(PublishedValues& published, const yaml::Node& node, const StudyReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "is a map of numbers: {H: 0.217, V: 0.114}");
  const yaml::Key number = form::number();
  for (const yaml::Entry& entry : node.entries)
    if (const auto value = yaml::below(read, entry.key).number(entry.value, number))
      published.values.push_back({entry.key, *value});
}

const ValuesTable& values_table() {
  static const ValuesTable table(
      "what is published", "{source: table 4, values: {haptic: 2e-5, visual: 4e-8}}",
      {yaml::needed(
           ValuesTable::Row{"source", "where it is printed", form::text(), &PublishedValues::source}),
       yaml::needed(
           ValuesTable::Row{"values", "the numbers by name", form::names(form::number(), 1), read_values})});
  return table;
}

PublishedTable::Row values_row(std::string name, std::string doc, PublishedValues PublishedStudy::*values) {
  return {std::move(name), std::move(doc), values_table().form,
          [=](PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
            values_table().read(node, published.*values, read);
          }};
}

void read_examples(PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
  for (const yaml::Node& item : node.as_list())
    values_table().read(item, published.examples.emplace_back(), read);
}

void read_stated_order(PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
  for (const yaml::Node& item : node.as_list()) {
    if (!item.is_list() || item.items.size() < 2)
      return read.fault(node.mark, "is a list of lists of conditions, the largest error first: [[V, H, HV]]");
    auto& names = published.order.emplace_back();
    for (const yaml::Node& name : item.items) names.push_back(read.text(name));
  }
}

const PublishedTable& published_table() {
  static const PublishedTable table(
      "what is published", "{means: {source: .., values: {..}}}",
      {values_row("means", "normalised errors by condition", &PublishedStudy::means),
       values_row("probabilities", "P of each factor", &PublishedStudy::probabilities),
       {"examples", "normalised errors of single participants", form::one_or_list(values_table().form),
        read_examples},
       {"order", "lists of conditions that the text orders, the largest error first",
        yaml::like("[[V, H, HV]]", form::list(form::list(form::text(), 2))), read_stated_order}});
  return table;
}

}  // namespace

const yaml::Key& published_form() {
  return published_table().form;
}

void read_published(PublishedStudy& published, const std::vector<std::string>& conditions,
                    const yaml::Node& node, const StudyReading& read) {
  if (!published_table().read(node, published, read)) return;
  const auto require = [&](const std::string& name, const std::string& key) {
    if (std::ranges::find(conditions, name) == conditions.end())
      yaml::below(read, key).fault(node.mark, fmt::format("there is no condition '{}'", name) +
                                                  yaml::nearest_or_all(name, conditions, "there are"));
  };
  for (const NamedValue& mean : published.means.values) require(mean.name, "means");
  for (const PublishedValues& example : published.examples)
    for (const NamedValue& error : example.values) require(error.name, "examples");
  for (const auto& names : published.order)
    for (const std::string& name : names) require(name, "order");
}

}  // namespace stepwire::study
