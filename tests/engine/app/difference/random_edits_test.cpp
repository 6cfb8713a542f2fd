// One known edit at a random place of each diagram of the repository: the difference is this edit and nothing
// else. Two such edits are merged.
#include <catch2/catch.hpp>

#include "engine/app/difference/merge.hpp"
#include "engine/app/difference/text_renames.hpp"
#include "engine/app/language/text_places.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/math/random.hpp"
#include "tests/engine/app/difference/comparing.hpp"

namespace stepwire::difference {
namespace {

using Lines = std::vector<std::string>;

/// Returns the numbers in the blocks of a file.
void add_numbers(const yaml::Node& node, std::vector<const yaml::Node*>& found) {
  for (const yaml::Node& item : node.items) add_numbers(item, found);
  for (const yaml::Entry& entry : node.entries) add_numbers(entry.value, found);
  const auto quantity = node.is_scalar() && !node.quoted ? unit::parse_quantity(node.text) : std::nullopt;
  if (quantity && quantity->value != 0.0) found.push_back(&node);
}

/// True for a value of an anchor, which an alias repeats.
bool is_repeated(const yaml::Node& node, const std::vector<const yaml::Node*>& all) {
  return std::ranges::count_if(all, [&](const yaml::Node* one) {
           return one->mark.line == node.mark.line && one->mark.column == node.mark.column;
         }) > 1;
}

/// A diagram of the repository under random edits.
class EditedDiagram {
 public:
  EditedDiagram(const std::string& file, std::uint64_t seed)
      : file_(file), seed_(seed), text_(io::read_file(file)), document_(yaml::read_document(file)) {}

  const std::string& text() const { return text_; }

  /// Returns the text with one number of a block times three; std::nullopt without a number.
  std::optional<std::string> with_number() const {
    std::vector<const yaml::Node*> numbers;
    if (const yaml::Node* blocks = document_.root.find("blocks")) add_numbers(*blocks, numbers);
    const std::vector<const yaml::Node*> all = numbers;
    std::erase_if(numbers, [&](const yaml::Node* node) { return is_repeated(*node, all); });
    if (numbers.empty()) return std::nullopt;
    const yaml::Node& node = *numbers[random_bits(seed_, 1) % numbers.size()];
    const auto quantity = unit::parse_quantity(node.text);
    const std::size_t unit = node.text.find(' ');
    const double number = std::stod(node.text) * 3.0;
    const std::string changed =
        fmt::format("{}{}", number, unit == std::string::npos ? "" : node.text.substr(unit));
    const language::TextPlaces places(text_);
    return quantity ? std::optional(language::spliced(text_, {{places.range(node), changed}})) : std::nullopt;
  }

  /// Returns the text with one block under another name, and its old name.
  std::pair<std::optional<std::string>, std::string> with_name() const {
    const yaml::Node* blocks = document_.root.find("blocks");
    if (!blocks) return {};
    const std::string name = blocks->entries[random_bits(seed_, 2) % blocks->entries.size()].key;
    Texts texts;
    return {with_new_names(every_block(), texts, file_, {{{NameKind::block, name}, "zz_" + name}}), name};
  }

  Lines differences(const std::string& before, const std::string& after) const {
    Texts old_texts, new_texts;
    old_texts.give(file_, before);
    new_texts.give(file_, after);
    Comparer comparer(every_block(), old_texts, new_texts);
    comparer.compare(file_, file_);
    return lines(comparer.result());
  }

 private:
  std::string file_;
  std::uint64_t seed_;
  std::string text_;
  yaml::Document document_;
};

}  // namespace

TEST_CASE("one changed number is one difference, in every diagram") {
  std::uint64_t seed = 0;
  for (const std::string& file : all_diagrams()) {
    const EditedDiagram diagram(file, ++seed);
    INFO(file);
    const auto changed = diagram.with_number();
    if (!changed) continue;
    const Lines found = diagram.differences(diagram.text(), *changed);
    CHECK(found.size() == 1);
    if (!found.empty()) CHECK_THAT(found.front(), Catch::StartsWith("~ "));
  }
}

TEST_CASE("one renamed block is one difference, in every diagram", "[full]") {
  std::uint64_t seed = 100, renamed = 0, count = 0;
  for (const std::string& file : all_diagrams()) {
    const EditedDiagram diagram(file, ++seed);
    const auto [changed, name] = diagram.with_name();
    INFO(file << ": " << name);
    if (name.empty()) continue;
    ++count;
    if (!changed) continue;
    ++renamed;
    CHECK(diagram.differences(diagram.text(), *changed) == Lines{"> " + name + " is now zz_" + name});
  }
  CHECK(renamed > 9 * count / 10);
}

TEST_CASE("a changed number and a renamed block merge in every diagram to what both say", "[full]") {
  std::uint64_t seed = 200;
  for (const std::string& file : all_diagrams()) {
    const EditedDiagram diagram(file, ++seed);
    const auto changed = diagram.with_number();
    const auto [renamed, name] = diagram.with_name();
    if (!changed || !renamed) continue;
    INFO(file << ": " << name);
    const Merged one = merge(every_block(), file, diagram.text(), *changed, *renamed);
    const Merged other = merge(every_block(), file, diagram.text(), *renamed, *changed);
    CHECK(one.conflicts.empty());
    CHECK(diagram.differences(one.text, other.text) == Lines{});
    CHECK(diagram.differences(*changed, one.text) == Lines{"> " + name + " is now zz_" + name});
    CHECK(diagram.differences(*renamed, other.text).size() == 1);
  }
}

}  // namespace stepwire::difference
