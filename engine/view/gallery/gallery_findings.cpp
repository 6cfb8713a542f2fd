#include "engine/view/gallery/gallery_findings.hpp"

#include <map>
#include <tuple>

#include "engine/view/gallery/gallery_tally.hpp"

namespace stepwire::gallery {
namespace {

Html link_to(const GalleryEntry& entry, const std::string& text) {
  return html("<a href=\"{}\">{}</a>", Address{page_of(entry)}, text);
}

Html unexpected(const Gallery& gallery) {
  Html items;
  for (const GalleryEntry& entry : gallery.entries) {
    if (!entry.error.empty()) items += html("<li>{}: did not run</li>\n", link_to(entry, full_name(entry)));
    for (const claim::Verdict& verdict : entry.verdicts)
      if (verdict.fails() || verdict.surprises())
        items +=
            html("<li>{}: {} – {}</li>\n", link_to(entry, full_name(entry)), verdict.that, verdict.word());
  }
  if (items.empty()) return {};
  return html(
      "<section id=\"unexpected\">\n<h2>What ends otherwise than expected</h2>\n<ul>\n{}</ul>\n</section>\n",
      items);
}

/// Returns a finding that is collapsed initially.
Html folded(const std::string& id, const std::string& title, const std::string& count, const Html& content) {
  return html(
      "<details class=\"finding\" id=\"{}\">\n<summary><h2>{}</h2> <span "
      "class=\"count\">{}</span></summary>\n{}</details>\n",
      id, title, count, content);
}

/// List of items for each entry that has some.
class EntryList {
 public:
  void add(const GalleryEntry& entry, const Html& items, std::size_t count) {
    if (count == 0) return;
    list_ += html("<dt>{}</dt>\n<dd><ul>\n{}</ul></dd>\n", link_to(entry, full_name(entry)), items);
    count_ += count;
  }
  std::size_t count() const { return count_; }
  Html list() const { return html("<dl class=\"by-entry\">\n{}</dl>\n", list_); }

 private:
  Html list_;
  std::size_t count_ = 0;
};

Html disagreements(const Gallery& gallery) {
  EntryList list;
  for (const GalleryEntry& entry : gallery.entries) {
    Html items;
    std::size_t count = 0;
    for (const claim::Verdict& verdict : entry.verdicts) {
      if (verdict.disagrees.empty() || verdict.holds) continue;
      items += html("<li>{}<br><em>{}</em></li>\n", verdict.that, verdict.disagrees);
      ++count;
    }
    list.add(entry, items, count);
  }
  if (list.count() == 0) return {};
  return folded("disagrees", "What disagrees with the text", counted(list.count(), "statement", "statements"),
                list.list());
}

Html departures(const Gallery& gallery) {
  EntryList list;
  for (const GalleryEntry& entry : gallery.entries) {
    Html items;
    for (const std::string& departure : entry.departures) items += html("<li>{}</li>\n", departure);
    list.add(entry, items, entry.departures.size());
  }
  if (list.count() == 0) return {};
  return folded("departures", "Departures from the text", counted(list.count(), "departure", "departures"),
                list.list());
}

/// Links to several entries: "Figure 24, 25, Table 2, Figure 27".
class EntryLinks {
 public:
  void add(const GalleryEntry& entry) {
    if (last_ == &entry) return;
    const std::string figure = "Figure ";
    const bool again = last_ && last_->label.starts_with(figure) && entry.label.starts_with(figure);
    if (last_) links_ += html(", ");
    links_ += link_to(entry, again ? entry.label.substr(figure.size()) : short_name(entry));
    last_ = &entry;
  }
  const Html& links() const { return links_; }

 private:
  Html links_;
  const GalleryEntry* last_ = nullptr;
};

/// Returns the assumptions. Values that entries share are listed once, in the order of their first
/// appearance.
Html assumed(const Gallery& gallery) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::vector<Key> order;
  std::map<Key, EntryLinks> links;
  for (const GalleryEntry& entry : gallery.entries)
    for (const Assumption& one : entry.assumptions) {
      const Key key{one.name.substr(one.name.rfind('.') + 1), one.value, one.doc};
      if (!links.contains(key)) order.push_back(key);
      links[key].add(entry);
    }
  if (order.empty()) return {};
  Html rows;
  for (const Key& key : order)
    rows += html("<tr><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td></tr>\n", std::get<0>(key),
                 std::get<1>(key), std::get<2>(key), links[key].links());
  return folded("assumed", "What is assumed", counted(order.size(), "value", "values"),
                html("<table class=\"assumed\">\n<thead><tr><th scope=\"col\">Parameter</th><th "
                     "scope=\"col\">Value</th><th "
                     "scope=\"col\">Meaning</th><th "
                     "scope=\"col\">Where</th></tr></thead>\n<tbody>\n{}</tbody></table>\n",
                     rows));
}

}  // namespace

Html gallery_findings(const Gallery& gallery) {
  const Html findings = html("{}{}{}", disagreements(gallery), departures(gallery), assumed(gallery));
  if (findings.empty()) return unexpected(gallery);
  return html("{}<div class=\"findings\">\n{}</div>\n", unexpected(gallery), findings);
}

}  // namespace stepwire::gallery
