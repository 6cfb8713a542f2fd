// Keys of each kind of plot, for the reader, the schema and the reference.
#include <fmt/format.h>

#include <algorithm>

#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

const char* const figure_example = "{plot: lines, x: time, y: rig.x}";

/// Adds keys that are not in the list yet.
template <class AnyRow>
void add(const std::vector<AnyRow>& rows, std::vector<yaml::Key>& keys) {
  for (const AnyRow& row : rows)
    if (std::ranges::find(keys, row.name, &yaml::Key::name) == keys.end()) keys.push_back(row);
}

yaml::Key channel_key(const Channel& channel) {
  yaml::Key form = channel.several ? form::one_or_list(form::series()) : form::series();
  yaml::Key made = key(channel.key, channel.doc, std::move(form));
  made.otherwise = channel.otherwise;
  return channel.required ? yaml::needed(std::move(made)) : made;
}

/// Returns the keys of a picture of one plot.
std::vector<yaml::Key> own_picture_keys() {
  std::vector<yaml::Key> keys;
  add(picture_keys(), keys);
  std::erase_if(keys, [](const yaml::Key& key) { return key.name == "panels"; });
  return keys;
}

std::vector<yaml::Key> keys_of_axes(const PlotKind& kind) {
  std::vector<PanelKey> rows = panel_keys();
  std::erase_if(rows, [&](const PanelKey& row) { return !kind.takes(row.needs); });
  return {rows.begin(), rows.end()};
}

}  // namespace

yaml::Key plot_form(const PlotKind& kind, bool alone) {
  std::vector<yaml::Key> keys{yaml::needed(key("plot", "kind of plot", form::word({kind.name})))};
  for (const Channel& channel : kind.channels) keys.push_back(channel_key(channel));
  add(kind.options, keys);
  if (!kind.read) add(keys_of_axes(kind), keys);
  std::vector<yaml::Key> picture = own_picture_keys();
  if (kind.read)
    std::erase_if(picture, [](const yaml::Key& key) { return key.name == "size" || key.name == "columns"; });
  if (alone) add(picture, keys);
  return key(kind.name, kind.doc,
             form::keys(fmt::format("a plot '{}'", kind.name), figure_example, std::move(keys)));
}

std::vector<yaml::Key> plot_forms(bool alone) {
  std::vector<yaml::Key> forms;
  for (const PlotKind& kind : plot_kinds())
    if (alone || !kind.read) forms.push_back(plot_form(kind, alone));
  return forms;
}

const yaml::Key& picture_form() {
  static const yaml::Key form = [] {
    yaml::Key keys = yaml::keys_form("a figure with panels", "{panels: [{plot: lines, x: time, y: rig.x}]}",
                                     picture_keys());
    for (yaml::Key& key : keys.of) key.required = key.name == "panels";
    return keys;
  }();
  return form;
}

const yaml::Key& figure_form() {
  static const yaml::Key form = [] {
    std::vector<yaml::Key::Word> kinds;
    for (const PlotKind& kind : plot_kinds()) kinds.push_back({kind.name, kind.doc});
    std::vector<yaml::Key> keys{
        yaml::needed(key("plot", "kind of plot, or `panels` in its place", form::words(std::move(kinds))))};
    add(panel_keys(), keys);
    add(picture_keys(), keys);
    return form::keys("a figure", figure_example, std::move(keys));
  }();
  return form;
}

}  // namespace stepwire::plot
