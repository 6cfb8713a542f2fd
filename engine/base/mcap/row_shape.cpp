#include "engine/base/mcap/row_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stepwire::mcap {

using json::Json;

RowShape::RowShape(const table::RunView& run) : run_(run) {
  for (const table::SeriesView& series : run.series) add(series);
  std::string text;
  spell(root_, text);
  end_ = std::move(text);
}

bool RowShape::is_column(const std::string& name) const {
  return std::ranges::find(run_.series, name, &table::SeriesView::name) != run_.series.end();
}

void RowShape::add(const table::SeriesView& series) {
  Member* place = &root_;
  std::size_t first = 0;
  for (std::size_t point = series.name.find('.');
       point != std::string::npos && !is_column(series.name.substr(0, point));
       point = series.name.find('.', first)) {
    const std::string key = series.name.substr(first, point - first);
    const auto known = std::ranges::find(place->members, key, &Member::key);
    place = known != place->members.end() ? &*known : &place->members.emplace_back(Member{key});
    first = point + 1;
  }
  place->members.push_back({series.name.substr(first), &series});
}

Json RowShape::schema_of(const Member& member) {
  if (member.series) {
    Json schema = Json::object().set("type", member.series->words.empty() ? "number" : "string");
    if (!member.series->unit.empty()) schema.set("unit", member.series->unit);
    return schema;
  }
  Json members = Json::object();
  for (const Member& one : member.members) members.set(one.key, schema_of(one));
  return Json::object().set("type", "object").set("properties", std::move(members));
}

std::string RowShape::schema(const std::string& title) const {
  return schema_of(root_).set("title", title).text(-1);
}

void RowShape::spell(const Member& member, std::string& text) {
  if (member.series) return pieces_.push_back({std::exchange(text, ""), member.series});
  const char* before = "{";
  for (const Member& one : member.members) {
    text += before + Json(one.key).text(-1) + ":";
    spell(one, text);
    before = ",";
  }
  text += member.members.empty() ? "{}" : "}";
}

void RowShape::append_row(std::string& text, std::size_t row) const {
  for (const Piece& piece : pieces_) {
    text += piece.text;
    const double number = piece.series->values[row];
    const auto& words = piece.series->words;
    if (!std::isfinite(number))
      text += "null";
    else if (number >= 0.0 && number < static_cast<double>(words.size()))
      text += Json(words[static_cast<std::size_t>(number)]).text(-1);
    else
      fmt::format_to(std::back_inserter(text), "{}", number);
  }
  text += end_;
}

}  // namespace stepwire::mcap
