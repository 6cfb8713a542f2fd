#include "engine/app/thesis/thesis_contents.hpp"

#include <charconv>
#include <limits>
#include <optional>

#include "engine/base/yaml/section.hpp"

namespace stepwire::thesis {

namespace {

using yaml::form;
using yaml::Node;
using Reading = yaml::SectionReading;
using SummaryTable = yaml::KeyTable<gallery::ChapterSummary, Reading>;
using ContentsTable = yaml::KeyTable<ThesisContents, Reading>;

std::optional<int> number_of(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

void read_tables(ThesisContents& contents, const Node& node, const Reading& read) {
  if (!node.is_map()) return read.fault(node.mark, "is a map of tables and figures: {1: 4}");
  for (const yaml::Entry& entry : node.entries) {
    const auto table = number_of(entry.key), figure = number_of(entry.value.text);
    if (!table || !figure) return read.fault(entry.mark, "has whole numbers: {1: 4}");
    contents.tables[*table] = *figure;
  }
}

void read_sentences(gallery::ChapterSummary& summary, const Node& node, const Reading& read) {
  for (const Node& sentence : node.as_list()) summary.sentences.push_back(read.text(sentence));
}

const SummaryTable& summary_table() {
  using Summary = gallery::ChapterSummary;
  static const SummaryTable table(
      "a summary", "{chapter: 4, title: .., sentences: [..]}",
      {yaml::needed(
           SummaryTable::Row{"chapter", "shown where an entry is of it", form::text(), &Summary::chapter}),
       yaml::needed(SummaryTable::Row{"title", "above it", form::text(), &Summary::title}),
       yaml::needed(SummaryTable::Row{"sentences", "what came of it", form::one_or_list(form::text()),
                                      read_sentences})});
  return table;
}

void read_summaries(ThesisContents& contents, const Node& node, const Reading& read) {
  for (const Node& item : node.as_list()) summary_table().read(item, contents.summaries.emplace_back(), read);
}

const ContentsTable& contents_table() {
  static const ContentsTable table(
      "the contents", "{title: .., introduction: ..}",
      {yaml::needed(ContentsTable::Row{"title", "of the front page", form::text(), &ThesisContents::title}),
       ContentsTable::Row{"introduction", "below it", form::text(), &ThesisContents::introduction},
       {"tables", "behind which figure each table stands", form::names(form::whole(1)), read_tables},
       {"summaries", "of chapters, in sentences", form::list(summary_table().form), read_summaries}});
  return table;
}

}  // namespace

std::pair<int, int> ThesisContents::place_of(const gallery::GalleryEntry& entry) const {
  if (entry.figure) return {*entry.figure, 0};
  const int table = entry.table.value_or(0);
  const auto place = tables.find(table);
  return {place == tables.end() ? std::numeric_limits<int>::max() : place->second, table};
}

ThesisContents read_contents(const std::string& diagrams) {
  const yaml::Document document = yaml::read_document(diagrams + "/gallery/contents.yaml");
  std::vector<yaml::Fault> faults;
  const Reading read("",
                     [&](const yaml::Mark& mark, const std::string& subject, const yaml::Message& message) {
                       faults.push_back({{document.file, mark}, subject, message, {}});
                     });
  ThesisContents contents;
  contents_table().read(document.root, contents, read);
  if (!faults.empty()) throw yaml::Error(std::move(faults));
  return contents;
}

}  // namespace stepwire::thesis
