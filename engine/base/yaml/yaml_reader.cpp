#include "engine/base/yaml/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <exception>
#include <istream>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/text_extent.hpp"
#include "engine/base/yaml/text_position.hpp"
#include "engine/base/yaml/text_source.hpp"
#include "engine/base/yaml/tree_builder.hpp"
#include "engine/base/yaml/yaml_message.hpp"

namespace stepwire::yaml {
namespace {

// Returns the position of a mark of the library; 0 for a null mark.
std::size_t spot_of(const YAML::Mark& mark) {
  return mark.is_null() ? 0 : static_cast<std::size_t>(mark.pos);
}

/// Repairs the escapes \N and \_, of which the library makes the single bytes 0x85 and 0xA0 instead of UTF-8.
/// The file itself is valid UTF-8.
std::string with_whole_escapes(const std::string& text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::ranges::all_of(text, is_ascii)) return text;
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = text::utf8_length(std::string_view(text).substr(i));
    if (length == 0) result += '\xc2';
    result.append(text, i, std::max<std::size_t>(1, length));
    i += std::max<std::size_t>(1, length);
  }
  return result;
}

// Forwards the library's events to the tree. The recursion of the library is bounded by the depth limit of
// the tree, since each level opens a list or a map.
class Events : public YAML::EventHandler {
 public:
  Events(TreeBuilder& tree, TextSource& source, LineIndex& spots)
      : tree_(tree), source_(source), spots_(spots) {}

  /// Returns the location of the last value.
  Mark last() { return place(last_); }

  /// Refuses a missing closing quote, which the library ignores at the end of the file; only the last text
  /// can lack it.
  void check_last_quote() {
    if (lacks_closing_quote(last_text_))
      tree_.fail(place(last_), "the closing quote of this text is missing");
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 1) return;
    const bool announced = spots_.text_at(spot_of(mark)).starts_with("---");
    tree_.fail(place(mark), announced ? "a second document starts here; a file holds one"
                                      : "text after the end of the document; check brackets and indentation");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    found(mark);
    const std::size_t start = value_start(spots_.text(), spot_of(mark));
    refuse_tag(mark, spots_.text_at(spot_of(mark)).starts_with('!') ? "!" : "");
    const bool written = starts_with_null(spots_.text_at(start));
    if (written) return tree_.empty(extent(start, word_end(spots_.text(), start)), true, anchor);
    const Mark nowhere = place(mark);
    tree_.empty({nowhere, nowhere}, false, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    found(mark);
    tree_.alias(extent(spot_of(mark), word_end(spots_.text(), spot_of(mark))).mark, anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    found(mark);
    refuse_tag(mark, tag);
    last_text_ = spots_.text_at(spot_of(mark));
    const std::size_t start = tree_.awaits_key() ? spot_of(mark) : value_start(spots_.text(), spot_of(mark));
    const std::size_t end = scalar_end(spots_.text(), start, value);
    tree_.scalar(extent(start, end), with_whole_escapes(value), tag == "!", anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(Node::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Node::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  Mark place(const YAML::Mark& mark) { return spots_.mark(spot_of(mark)); }
  void found(const YAML::Mark& mark) {
    last_ = mark;
    source_.progress();
  }
  /// Records where the last value ends.
  MarkRange extent(std::size_t start, std::size_t end) {
    const Mark mark = spots_.mark(start);
    behind_ = end;
    return {mark, spots_.mark(end)};
  }
  void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    found(mark);
    refuse_tag(mark, tag);
    const std::size_t start = value_start(spots_.text(), spot_of(mark));
    const std::string_view here = spots_.text_at(start);
    const bool in_brackets = here.starts_with('[') || here.starts_with('{');
    in_brackets_.push_back(in_brackets);
    behind_ = start + (in_brackets ? 1 : 0);
    tree_.open(kind, spots_.mark(start), anchor);
  }
  void close() {
    if (in_brackets_.back()) behind_ = bracket_end(spots_.text(), behind_);
    in_brackets_.pop_back();
    tree_.close(spots_.mark(behind_));
  }
  // Refuses written tags. The library uses "?" for no tag, and "!" for a quoted scalar as well as an explicit
  // "!".
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    const bool written =
        tag != "" && tag != "?" && (tag != "!" || spots_.text_at(spot_of(mark)).starts_with('!'));
    if (written) tree_.fault(place(mark), "tags (!) are not used here; quote text that starts with !");
  }

  TreeBuilder& tree_;
  TextSource& source_;
  LineIndex& spots_;
  YAML::Mark last_;
  std::vector<bool> in_brackets_;  ///< of each open list and map
  std::size_t behind_ = 0;         ///< end of the last value
  std::string_view last_text_;
  int documents_ = 0;
};

// Throws the error of the library with a helpful location. The parser points to where a bracket or quote
// should end; the user needs its start. Tabs in the indentation are reported first, since they look like
// blanks.
[[noreturn]] void explain(TreeBuilder& tree, LineIndex& spots, Mark last, const YAML::Exception& wrong) {
  const auto text = [](Mark mark) { return std::to_string(mark.line) + ":" + std::to_string(mark.column); };
  const Mark place = spots.mark(spot_of(wrong.mark));
  if (const auto tab = spots.tab_in_indentation(spot_of(wrong.mark)))
    tree.fail({place.line, *tab}, "a tab in the indentation; use blanks");
  if (wrong.msg == YAML::ErrorMsg::EOF_IN_SCALAR)
    tree.fail(place,
              "the file ends inside a text that starts after " + text(last) + "; a closing quote is missing");
  const bool in_brackets =
      wrong.msg == YAML::ErrorMsg::END_OF_MAP_FLOW || wrong.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW;
  tree.fail(place,
            yaml_message(wrong.msg) + (in_brackets ? " (opened at " + text(tree.innermost()) + ")" : ""));
}

}  // namespace

Node read_yaml(std::string_view text, const std::string& file, const DocumentLimits& limits) {
  TreeBuilder tree(file, limits);
  TextSource source(text);
  LineIndex spots(text);
  Events events(tree, source, spots);
  try {
    std::istream stream(&source);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(events)) {
    }
    events.check_last_quote();
  } catch (const YAML::Exception& wrong) {
    explain(tree, spots, events.last(), wrong);
  } catch (const TextSource::TooFarAhead&) {
    tree.fail(events.last(),
              "a list or map in brackets that is too long starts here; put its values into a data file");
  } catch (const Error&) {
    throw;
  } catch (const std::exception& wrong) {
    tree.fail(events.last(), std::string("cannot be read as YAML: ") + wrong.what());
  }
  return tree.take();
}

}  // namespace stepwire::yaml
