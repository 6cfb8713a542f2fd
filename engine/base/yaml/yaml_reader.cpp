#include "engine/base/yaml/yaml_reader.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <exception>
#include <istream>
#include <numeric>
#include <streambuf>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/base/yaml/text_extent.hpp"
#include "engine/base/yaml/text_position.hpp"

namespace stepwire::yaml {
namespace {

/// Stream buffer over a text that bounds the memory of the YAML scanner. A scanner that searches the end of a
/// flow list accumulates tokens, each much larger than its character. The buffer counts the token characters
/// read since the last progress().
class TextSource : public std::streambuf {
 public:
  explicit TextSource(std::string_view text);

  /// Resets the count, after the parser has emitted an event.
  void progress() { signs_ = 0; }
  /// Thrown from a read after too many token characters without progress().
  struct TooFarAhead {};

 protected:
  std::streamsize xsgetn(char* to, std::streamsize count) override;

 private:
  std::size_t signs_ = 0;
};

// Most characters that can make a token between two events. A flow list of about this many numbers is
// readable; its tokens take less than 100 MB.
constexpr std::size_t max_signs = 250'000;

bool makes_token(char c) {
  return c == ',' || c == '[' || c == '{' || c == ']' || c == '}' || c == ':' || c == '?' || c == '-' ||
         c == '&' || c == '*' || c == '!' || c == '"' || c == '\'';
}

TextSource::TextSource(std::string_view text) {
  char* begin = const_cast<char*>(text.data());  // required by std::streambuf, which does not write here
  setg(begin, begin, begin + text.size());
}

std::streamsize TextSource::xsgetn(char* to, std::streamsize count) {
  const std::streamsize taken = std::streambuf::xsgetn(to, count);
  signs_ += static_cast<std::size_t>(std::count_if(to, to + taken, makes_token));
  if (signs_ > max_signs) throw TooFarAhead{};
  return taken;
}

/// Range from the first character of a value to just after its last one.
struct MarkRange {
  Mark mark, end;
};

/// Builds a tree of nodes from parser events. It checks keys, expands aliases and enforces the limits on
/// depth and size. `anchor` is 0 for a value without one.
class TreeBuilder {
 public:
  TreeBuilder(std::string file, const DocumentLimits& limits);

  void open(Node::Kind kind, Mark mark, std::size_t anchor);
  /// Closes the innermost open list or map; `end` is just after it.
  void close(Mark end);
  void scalar(const MarkRange& place, const std::string& text, bool quoted, std::size_t anchor);
  /// Adds a written null or an omitted value; the latter has the location of its key.
  void empty(const MarkRange& place, bool written, std::size_t anchor);
  void alias(Mark mark, std::size_t anchor);

  /// True where the next value is the key of a map.
  bool awaits_key() const;
  /// Returns the start of the innermost open list or map.
  Mark innermost() const;

  /// Records a fault and continues; throws Error after too many.
  void fault(Mark mark, Message message);
  /// Throws Error with this fault and all earlier ones.
  [[noreturn]] void fail(Mark mark, Message message);
  /// Returns the finished tree; throws Error if there were faults.
  Node take();

 private:
  struct Level {
    Node* node;
    bool awaits_value = false;
  };
  using Path = std::vector<std::size_t>;

  void key(const MarkRange& place, std::string text, std::size_t anchor);
  Node& attach(Node node, std::size_t anchor);
  void spend(std::size_t cost, Mark mark);
  void check_depth(std::size_t depth, Mark mark);
  void check_double_keys(const Node& map);
  Node& at(const Path& path);

  std::string file_;
  DocumentLimits limits_;
  Node root_;
  std::vector<Level> open_;  // pointers remain valid: a vector grows only while none of its elements is open
  std::unordered_map<std::size_t, Path> anchors_;
  std::size_t cost_ = 0;
  Faults faults_;
};

constexpr std::size_t characters_per_node = 32;  // bounds copies of long texts by aliases
constexpr std::size_t nodes_per_anchor = 8;      // approximate cost of storing the path to an anchor

struct Size {
  std::size_t cost = 0;
  std::size_t depth = 0;
};

std::size_t cost_of(const std::string& text) {
  return 1 + text.size() / characters_per_node;
}

Size size_of(const Node& node) {
  Size size{cost_of(node.text), 0};
  const auto add = [&](const Node& child) {
    const Size inner = size_of(child);
    size.cost += inner.cost;
    size.depth = std::max(size.depth, inner.depth);
  };
  for (const Node& item : node.items) add(item);
  for (const Entry& entry : node.entries) {
    size.cost += entry.key.size() / characters_per_node;
    add(entry.value);
  }
  if (node.is_list() || node.is_map()) ++size.depth;
  return size;
}

TreeBuilder::TreeBuilder(std::string file, const DocumentLimits& limits)
    : file_(std::move(file)), limits_(limits) {
  root_.mark = root_.end = {1, 1};
}

void TreeBuilder::open(Node::Kind kind, Mark mark, std::size_t anchor) {
  if (awaits_key())
    fail(mark, "a list or a map cannot be a key; close the bracket, or quote text that starts with [ or {");
  check_depth(open_.size() + 1, mark);
  spend(1, mark);
  Node node;
  node.kind = kind;
  node.mark = mark;
  open_.push_back({&attach(std::move(node), anchor)});
}

void TreeBuilder::close(Mark end) {
  if (open_.back().node->is_map()) check_double_keys(*open_.back().node);
  open_.back().node->end = end;
  open_.pop_back();
}

void TreeBuilder::scalar(const MarkRange& place, const std::string& text, bool quoted, std::size_t anchor) {
  spend(cost_of(text), place.mark);
  if (awaits_key()) return key(place, text, anchor);
  Node node;
  node.kind = Node::Kind::scalar;
  node.quoted = quoted;
  node.mark = place.mark;
  node.end = place.end;
  node.text = text;
  attach(std::move(node), anchor);
}

void TreeBuilder::empty(const MarkRange& place, bool written, std::size_t anchor) {
  spend(1, place.mark);
  if (awaits_key()) {
    fault(place.mark, written ? "null is no key; quote it if it is meant as a word"
                              : "a key is missing before the value");
    return key(place, "", 0);
  }
  Node node;
  node.mark = place.mark;
  node.end = place.end;
  if (!written && !open_.empty() && open_.back().node->is_map()) {
    const Entry& entry = open_.back().node->entries.back();
    node.mark = entry.mark;
    node.end = entry.end;
    if (entry.key.find(':') != std::string::npos)
      fault(entry.mark, fault_text("'{}' is a key without a value; a blank is missing after ':'", entry.key));
  }
  attach(std::move(node), anchor);
}

void TreeBuilder::alias(Mark mark, std::size_t anchor) {
  if (awaits_key()) {
    fault(mark, "an alias (*name) cannot be a key; write the key out");
    return key({mark, mark}, "", 0);
  }
  const auto known = anchors_.find(anchor);
  if (known == anchors_.end())
    return empty({mark, mark}, true, 0);  // its anchor was on a key, which is already a fault
  const Node& meant = at(known->second);
  const bool is_open =
      std::any_of(open_.begin(), open_.end(), [&](auto& level) { return level.node == &meant; });
  if (is_open) fail(mark, "the alias stands inside the value that it names, so that it would never end");
  const Size size = size_of(meant);
  check_depth(open_.size() + size.depth, mark);
  spend(size.cost, mark);
  Node copy = meant;
  attach(std::move(copy), 0);
}

Mark TreeBuilder::innermost() const {
  return open_.empty() ? root_.mark : open_.back().node->mark;
}

void TreeBuilder::fault(Mark mark, Message message) {
  faults_.add({.place = {file_, mark}, .subject = "", .message = std::move(message), .used_by = {}});
}

void TreeBuilder::fail(Mark mark, Message message) {
  fault(mark, std::move(message));
  throw Error(faults_.list());
}

Node TreeBuilder::take() {
  faults_.throw_if_any();
  return std::move(root_);
}

bool TreeBuilder::awaits_key() const {
  return !open_.empty() && open_.back().node->is_map() && !open_.back().awaits_value;
}

void TreeBuilder::key(const MarkRange& place, std::string text, std::size_t anchor) {
  if (anchor != 0) fault(place.mark, "an anchor (&name) belongs to a value, not to a key");
  if (text == "<<")
    fault(place.mark, "merge keys (<<) are not known here; write the keys out, or give the value an alias");
  open_.back().node->entries.push_back({std::move(text), place.mark, {}, place.end});
  open_.back().awaits_value = true;
}

Node& TreeBuilder::attach(Node node, std::size_t anchor) {
  Node* place = &root_;
  if (!open_.empty()) {
    Node& parent = *open_.back().node;
    open_.back().awaits_value = false;
    place = parent.is_map() ? &parent.entries.back().value : &parent.items.emplace_back();
  }
  *place = std::move(node);
  if (anchor != 0) {
    spend(nodes_per_anchor, place->mark);
    Path path;
    for (const Level& level : open_)
      path.push_back((level.node->is_map() ? level.node->entries.size() : level.node->items.size()) - 1);
    anchors_[anchor] = std::move(path);
  }
  return *place;
}

void TreeBuilder::spend(std::size_t cost, Mark mark) {
  cost_ += cost;
  if (cost_ <= limits_.nodes) return;
  fail(mark, fmt::format("the file holds more than {} values (aliases expanded), more than is read",
                         limits_.nodes));
}

void TreeBuilder::check_depth(std::size_t depth, Mark mark) {
  if (depth <= static_cast<std::size_t>(limits_.depth)) return;
  fail(mark, fmt::format("nested deeper than {} levels, more than is read", limits_.depth));
}

void TreeBuilder::check_double_keys(const Node& map) {
  const std::vector<Entry>& entries = map.entries;
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return entries[a].key < entries[b].key; });
  std::size_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Entry& original = entries[order[first]];
    const Entry& entry = entries[order[i]];
    if (entry.key != original.key) {
      first = i;
    } else if (!entry.key.empty()) {
      fault(entry.mark, fault_text("'{}' is given twice, first at {}:{}; leave one out", entry.key,
                                   original.mark.line, original.mark.column));
    }
  }
}

Node& TreeBuilder::at(const Path& path) {
  Node* node = &root_;
  for (const std::size_t index : path)
    node = node->is_map() ? &node->entries[index].value : &node->items[index];
  return *node;
}

struct Wording {
  std::string_view library, ours;
};

constexpr std::array wordings{
    Wording{"illegal map value",
            "a ': ' cannot stand here; check the indentation, look for a missing ':' just above, "
            "or quote text that holds ': '"},
    Wording{"end of map not found",
            "expected 'key: value' here; check the indentation, and quote text that holds ': ' or starts "
            "with a sign"},
    Wording{"end of map flow not found",
            "expected ',' or '}' here; a ',', a bracket or a quote is missing (text that holds ': ' or ', ' "
            "needs quotes)"},
    Wording{"end of sequence not found", "expected '- ' here; check the indentation"},
    Wording{"end of sequence flow not found",
            "expected ',' or ']' here; a ',', a bracket or a quote is missing"},
    Wording{"illegal flow end", "this bracket closes nothing, or not the kind that was opened last"},
    Wording{"illegal block entry", "a '- ' cannot stand here; put it on a line of its own"},
    Wording{"illegal map key", "a key cannot stand here; check the indentation"},
    Wording{"unknown token", "this character starts nothing in YAML; put quotes around the text"},
    Wording{"illegal document indicator in scalar",
            "'---' or '...' inside a text; a closing quote is missing"},
    Wording{"illegal tab when looking for indentation", "a tab in the indentation; use blanks"},
    Wording{"the referenced anchor is not defined",
            "the alias (*name) names no anchor (&name) before it; quote text that starts with *"},
    Wording{"alias not found after *", "a name is missing after '*'; quote text that starts with *"},
    Wording{"anchor not found after &", "a name is missing after '&'; quote text that starts with &"},
    Wording{"cannot assign multiple anchors to the same node", "a value can have one anchor (&name) only"},
    Wording{"bad file", "nested too deeply to be read"},
};

/// Rewrites an error message of the YAML library, which uses terms of parser authors, for users.
std::string yaml_message(std::string_view library_message) {
  for (const Wording& wording : wordings)
    if (wording.library == library_message) return std::string(wording.ours);
  return "not valid YAML: " + std::string(library_message);
}

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
