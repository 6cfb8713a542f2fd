#pragma once

#include <limits>
#include <nlohmann/json.hpp>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::testing {

// Reads a figure of plots back from its JSON, as any other program would, by the names of the fields.

inline void read(const nlohmann::json& from, double& to) {
  to = from.is_null() ? std::numeric_limits<double>::quiet_NaN() : from.get<double>();
}
inline void read(const nlohmann::json& from, bool& to) {
  to = from.get<bool>();
}
inline void read(const nlohmann::json& from, std::size_t& to) {
  to = from.get<std::size_t>();
}
inline void read(const nlohmann::json& from, std::string& to) {
  to = from.get<std::string>();
}
template <std::size_t count>
void read(const nlohmann::json& from, std::array<double, count>& to) {
  to = from.get<std::array<double, count>>();
}

template <class Enum, class Words>
void read_word(const nlohmann::json& from, Enum& to, const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (from.get<std::string>() == words[i]) return void(to = static_cast<Enum>(i));
  throw std::invalid_argument(from.dump());
}
inline void read(const nlohmann::json& from, plot::PlotSpec::Legend& to) {
  read_word(from, to, plot::PlotSpec::legends);
}
inline void read(const nlohmann::json& from, plot::TextMark::Align& to) {
  read_word(from, to, plot::TextMark::alignments);
}
inline void read(const nlohmann::json& from, plot::PointsMark::Symbol& to) {
  read_word(from, to, plot::PointsMark::symbols);
}

template <class Struct>
requires requires {
  Struct::fields();
}
void read(const nlohmann::json& from, Struct& to);
inline void read(const nlohmann::json& from, plot::PlotMark& to);

template <class Value>
void read(const nlohmann::json& from, std::optional<Value>& to) {
  read(from, to.emplace());
}
template <class Value>
void read(const nlohmann::json& from, std::vector<Value>& to) {
  for (const nlohmann::json& item : from) read(item, to.emplace_back());
}

template <class Struct>
requires requires {
  Struct::fields();
}
void read(const nlohmann::json& from, Struct& to) {
  std::size_t found = 0;
  const auto one = [&](const auto& field) {
    if (!from.contains(field.name)) return;
    read(from.at(field.name), to.*field.member);
    ++found;
  };
  std::apply([&](const auto&... all) { (one(all), ...); }, Struct::fields());
  const std::size_t others = from.contains("mark") + from.contains("panel") + from.contains("box");
  if (found + others != from.size()) throw std::invalid_argument("unknown field in " + from.dump());
}

template <std::size_t index = 0>
void read_mark(const nlohmann::json& from, plot::PlotMark& to) {
  if constexpr (index == std::variant_size_v<plot::PlotMark>) {
    throw std::invalid_argument(from.dump());
  } else {
    using Type = std::variant_alternative_t<index, plot::PlotMark>;
    if (from.at("mark") != Type::name) return read_mark<index + 1>(from, to);
    read(from, to.emplace<Type>());
  }
}
inline void read(const nlohmann::json& from, plot::PlotMark& to) {
  read_mark(from, to);
}

/// The figure of such a text.
inline plot::FigureSpec figure_of_json(const std::string& text) {
  const nlohmann::json from = nlohmann::json::parse(text);
  plot::FigureSpec figure{
      from.at("title"), from.at("width"), from.at("height"), from.value("aligned", false), {}};
  for (const nlohmann::json& panel : from.at("panels")) {
    const auto box = panel.at("box").get<std::vector<double>>();
    plot::PlotSpec plot;
    read(panel, plot);
    figure.panels.push_back({box.at(0), box.at(1), box.at(2), box.at(3), std::move(plot)});
  }
  return figure;
}

}  // namespace stepwire::testing
