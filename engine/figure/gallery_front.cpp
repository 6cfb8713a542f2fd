#include "engine/figure/gallery_front.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "engine/figure/svg.hpp"

namespace stepwire {
namespace {

/// How many claims there are, and how they ended.
struct Tally {
  std::size_t all = 0, hold = 0, known = 0, fail = 0, surprise = 0, errors = 0, invariants = 0;

  void count(const GalleryEntry& entry) {
    errors += entry.error.empty() ? 0 : 1;
    for (const Verdict& verdict : entry.verdicts) count(verdict);
  }
  void count(const Verdict& verdict) {
    if (verdict.kind == Claim::Kind::invariant) {
      ++(verdict.holds ? invariants : fail);
      return;
    }
    ++all;
    if (verdict.surprises())
      ++surprise;
    else if (verdict.holds)
      ++hold;
    else
      ++(verdict.fails() ? fail : known);
  }
  bool bad() const { return fail + surprise + errors > 0; }
};

Tally tally_of(const Gallery& gallery) {
  Tally tally;
  for (const GalleryEntry& entry : gallery.entries) tally.count(entry);
  return tally;
}

std::string link_to_card(std::size_t index, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", gallery_anchor(index), text);
}

/// "Figure 15", or the title of what has no label.
std::string short_name(const GalleryEntry& entry) {
  return markup_escaped(entry.label.empty() ? entry.title : entry.label);
}

std::string summary(const Gallery& gallery) {
  const Tally tally = tally_of(gallery);
  std::string line = fmt::format("{} of {} claims hold", tally.hold, tally.all);
  if (tally.invariants > 0) line += fmt::format(", {} invariants held throughout", tally.invariants);
  if (tally.known > 0) line += fmt::format(", {} known not to hold", tally.known);
  if (tally.fail > 0) line += fmt::format(", {} {} not hold", tally.fail, tally.fail == 1 ? "does" : "do");
  if (tally.surprise > 0)
    line += fmt::format(", {} {} after all", tally.surprise, tally.surprise == 1 ? "holds" : "hold");
  if (tally.errors > 0)
    line += fmt::format(", {} {} not run", tally.errors, tally.errors == 1 ? "file did" : "files did");
  return fmt::format("<p class=\"summary {}\">{}.</p>\n", tally.bad() ? "bad" : "good", line);
}

/// What a reader must look at first: every claim that ended otherwise than expected.
std::string failures(const Gallery& gallery) {
  std::string items;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) {
    const auto& entry = gallery.entries[i];
    const auto add = [&](const std::string& text) {
      items +=
          fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", gallery_anchor(i), gallery_title(entry), text);
    };
    if (!entry.error.empty()) add("did not run");
    for (const auto& verdict : entry.verdicts)
      if (verdict.fails() || verdict.surprises()) add(markup_escaped(verdict.that) + " – " + verdict.word());
  }
  return items.empty() ? "" : "<ul class=\"failures\">\n" + items + "</ul>\n";
}

/// One entry of the list of what is reproduced.
std::string reproduced_item(const GalleryEntry& entry, std::size_t index) {
  Tally tally;
  tally.count(entry);
  const char* look = tally.bad() ? "bad" : tally.known > 0 ? "known" : "good";
  const std::string claims = tally.all > 0 ? fmt::format("{} of {}", tally.hold, tally.all) : "";
  return fmt::format(
      "<li class=\"{}\"><span class=\"name\">{}</span> {} <span class=\"verdict\">{}</span></li>\n", look,
      link_to_card(index, short_name(entry)), entry.label.empty() ? "" : markup_escaped(entry.title), claims);
}

std::string chapter_of(const GalleryEntry& entry) {
  return entry.section.substr(0, entry.section.find('.'));
}

/// Links to all cards by chapter, with how many of their claims hold.
std::string reproduced(const Gallery& gallery) {
  std::string html, chapter;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) {
    const GalleryEntry& entry = gallery.entries[i];
    if (i == 0 || chapter_of(entry) != chapter) {
      chapter = chapter_of(entry);
      if (i > 0) html += "</ul>\n";
      if (!chapter.empty()) html += fmt::format("<h3>Chapter {}</h3>\n", markup_escaped(chapter));
      html += "<ul class=\"index\">\n";
    }
    html += reproduced_item(entry, i);
  }
  if (html.empty()) return {};
  return "<section id=\"reproduced\">\n<h2>What is reproduced</h2>\n" + html + "</ul>\n</section>\n";
}

/// Statements of the source that are known not to hold, each with the reason.
std::string disagreements(const Gallery& gallery) {
  std::string items;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i)
    for (const Verdict& verdict : gallery.entries[i].verdicts)
      if (!verdict.disagrees.empty() && !verdict.holds)
        items +=
            fmt::format("<li>{}: {}<br><em>{}</em></li>\n", link_to_card(i, short_name(gallery.entries[i])),
                        markup_escaped(verdict.that), markup_escaped(verdict.disagrees));
  if (items.empty()) return {};
  return "<section id=\"disagrees\">\n<h2>What disagrees with the text</h2>\n<ul class=\"disagrees\">\n" +
         items + "</ul>\n</section>\n";
}

/// Links to several cards: "Figure 24, 25, Table 2, Figure 27".
class CardLinks {
 public:
  void add(const GalleryEntry& entry, std::size_t index) {
    if (!html_.empty() && index == last_) return;
    const std::string figure = "Figure ";
    const bool again = after_figure_ && entry.label.starts_with(figure);
    const std::string text = again ? markup_escaped(entry.label.substr(figure.size())) : short_name(entry);
    html_ += (html_.empty() ? "" : ", ") + link_to_card(index, text);
    last_ = index;
    after_figure_ = entry.label.starts_with(figure);
  }
  const std::string& html() const { return html_; }

 private:
  std::string html_;
  std::size_t last_ = 0;
  bool after_figure_ = false;
};

/// Assumed values, one line for what several entries share, in the order of their first appearance.
std::string assumed(const Gallery& gallery) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::vector<Key> order;
  std::map<Key, CardLinks> links;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i)
    for (const Assumption& one : gallery.entries[i].assumptions) {
      const Key key{one.name.substr(one.name.rfind('.') + 1), one.value, one.doc};
      if (!links.contains(key)) order.push_back(key);
      links[key].add(gallery.entries[i], i);
    }
  if (order.empty()) return {};
  std::string rows;
  for (const Key& key : order)
    rows += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        markup_escaped(std::get<0>(key)), markup_escaped(std::get<1>(key)),
                        markup_escaped(std::get<2>(key)), links[key].html());
  return fmt::format(
      "<section id=\"assumed\">\n<h2>What is assumed</h2>\n<details>\n<summary>{} {} that the text does not "
      "give</summary>\n<table>\n<tr><th scope=\"col\">Parameter</th><th scope=\"col\">Value</th><th "
      "scope=\"col\">Meaning</th><th scope=\"col\">Where</th></tr>\n{}</table>\n</details>\n</section>\n",
      order.size(), order.size() == 1 ? "value" : "values", rows);
}

}  // namespace

std::string gallery_anchor(std::size_t index) {
  return fmt::format("entry-{}", index + 1);
}

std::string gallery_title(const GalleryEntry& entry) {
  if (entry.label.empty() || entry.title.empty()) return markup_escaped(entry.label + entry.title);
  return fmt::format("<span class=\"label\">{}</span> {}", markup_escaped(entry.label),
                     markup_escaped(entry.title));
}

std::string gallery_front(const Gallery& gallery) {
  return summary(gallery) + failures(gallery) + reproduced(gallery) + disagreements(gallery) +
         assumed(gallery);
}

}  // namespace stepwire
