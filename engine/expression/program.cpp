#include "engine/expression/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>

#include "engine/expression/draws.hpp"
#include "engine/expression/expression.hpp"
#include "engine/expression/function.hpp"
#include "engine/expression/token.hpp"

namespace stepwire {
namespace {

using Known = std::function<bool(std::string_view)>;

constexpr std::size_t longest_text =
    5000;  // the parser library takes 20,000 characters, and ours become up to four
constexpr std::size_t deepest = 200;

/// A run of signs before a value, such as "-!x": the parser library takes one sign only, so each run becomes
/// one of its own. Inside a "not" a minus changes nothing.
class Prefix {
 public:
  void add(bool minus) {
    if (minus && nots_ == 0) negative_ = !negative_;
    if (!minus) nots_ = nots_ == 1 ? 2 : 1;
  }

  /// Set apart by a blank, or "a<!b" would have a sign "<!".
  std::string take() {
    static constexpr std::array<std::array<const char*, 3>, 2> signs{{{"", " !", " ~"}, {" -", " #", " $"}}};
    const std::string result = signs[negative_ ? 1 : 0][nots_];
    *this = {};
    return result;
  }

 private:
  bool negative_ = false;
  std::size_t nots_ = 0;
};

/// A pair of parentheses, or the whole text.
struct Frame {
  Token open;
  std::optional<Token> function;
  int values = 1;
  std::vector<Token> questions{};  // '?' that wait for their ':'
};

/// Walks the pieces once. A value and a sign alternate; what is open is on a stack of our own, so that no
/// text can exhaust the real one.
class Translator {
 public:
  Translator(std::string_view text, const Known& known) : tokens_(tokens(text, known)), known_(known) {}

  Program run() {
    if (tokens_.size() == 1) throw ExpressionError("the expression is empty", 0);
    frames_.push_back({});
    for (; tokens_[at_].kind != Token::Kind::end; ++at_) {
      value_comes_ ? value(tokens_[at_]) : sign(tokens_[at_]);
    }
    finish(tokens_[at_]);
    return std::move(program_);
  }

 private:
  [[noreturn]] static void fail(const Token& token, const std::string& message) {
    throw ExpressionError(message, token.position);
  }

  static std::string shown(const Token& token) {
    return token.kind == Token::Kind::end ? "the end" : fmt::format("'{}'", token.text);
  }

  void value(const Token& token) {
    if (token.kind == Token::Kind::number) return number(token.value, token.dimension);
    if (token.kind == Token::Kind::name) return name(token);
    if (token.is("(")) return open(token, std::nullopt);
    if (token.is("-") || token.is("!")) return prefix_.add(token.is("-"));
    if (!token.is("+")) missing_value(token);
  }

  [[noreturn]] void missing_value(const Token& token) const {
    const bool power = at_ > 0 && token.is("*") && tokens_[at_ - 1].is("*");
    fail(token, fmt::format("a value is missing before {}{}", shown(token), power ? "; a power is x^y" : ""));
  }

  void number(double value, const std::optional<Dimension>& dimension = {}) {
    program_.code += fmt::format("{}c{}", prefix_.take(), place_of(value, dimension));
    value_comes_ = false;
  }

  /// Bare numbers stand once in a program, however often in the text.
  std::size_t place_of(double value, const std::optional<Dimension>& dimension) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::size_t next = program_.numbers.size();
    const std::size_t place = dimension ? next : numbers_.try_emplace(bits, next).first->second;
    if (place == next) {
      program_.numbers.push_back(value);
      program_.dimensions.push_back(dimension);
    }
    return place;
  }

  void name(const Token& token) {
    const bool called = tokens_[at_ + 1].is("(");
    const bool exists = known_ && known_(token.text);
    if (called) return call(token, exists);
    if (!exists && token.text == "pi") return number(std::numbers::pi);
    if (!exists && token.text == "e") return number(std::numbers::e);
    if (!exists && find_function(token.text))
      fail(token, fmt::format("'{0}' is a function; write {0}(...)", token.text));
    if (!exists && known_) fail(token, fmt::format("unknown name '{}'", token.text));
    variable(token);
  }

  void variable(const Token& token) {
    const auto [place, added] = variables_.try_emplace(token.text, program_.variables.size());
    if (added) program_.variables.emplace_back(token.text);
    program_.uses.push_back({place->second, token.position});
    program_.code += fmt::format("{}v{}", prefix_.take(), place->second);
    value_comes_ = false;
  }

  void call(const Token& token, bool exists) {
    if (!find_function(token.text))
      fail(token, exists ? fmt::format("'{}' is a value, not a function", token.text)
                         : fmt::format("unknown function '{}'", token.text));
    program_.code += prefix_.take();
    program_.code += token.text;
    program_.places.push_back(token.position);
    open(tokens_[++at_], token);
  }

  void open(const Token& token, const std::optional<Token>& function) {
    if (frames_.size() > deepest) fail(token, fmt::format("more than {} parentheses are open", deepest));
    frames_.push_back({token, function});
    program_.code += prefix_.take() + '(';
    value_comes_ = true;
  }

  void sign(const Token& token) {
    Frame& frame = frames_.back();
    if (token.kind != Token::Kind::sign || token.is("(") || token.is("!")) missing_operator(token);
    if (token.is(")")) return close(token);
    if (token.is(",")) next_value(token, frame);
    if (token.is("?")) frame.questions.push_back(token);
    if (token.is(":")) answer(token, frame);
    if (!token.is(",") && !token.is("?") && !token.is(":")) program_.places.push_back(token.position);
    program_.code += token.text;
    value_comes_ = true;
  }

  [[noreturn]] static void missing_operator(const Token& token) {
    const bool power = token.text == "e" || token.text == "E";
    fail(token, fmt::format("an operator is missing before {}{}", shown(token),
                            power ? "; a power of ten has no blanks, as in 2e-3" : ""));
  }

  static void answer(const Token& token, Frame& frame) {
    if (frame.questions.empty()) fail(token, "':' without '?'");
    frame.questions.pop_back();
  }

  static void next_value(const Token& token, Frame& frame) {
    if (!frame.function) fail(token, "',' only separates the values of a function");
    check_questions(frame);
    ++frame.values;
  }

  static void check_questions(const Frame& frame) {
    if (!frame.questions.empty()) fail(frame.questions.back(), "'?' without ':'");
  }

  void close(const Token& token) {
    const Frame frame = frames_.back();
    if (frames_.size() == 1) fail(token, "')' without '('");
    check_questions(frame);
    if (frame.function) check_arity(*frame.function, frame.values);
    frames_.pop_back();
    program_.code += ')';
  }

  static void check_arity(const Token& function, int values) {
    const Arity& arity = *find_function(function.text);
    if (values >= arity.least && values <= arity.most) return;
    if (function.text == "min" || function.text == "max")
      fail(function, fmt::format("'{0}' of one value is that value; {0}(a, b) compares several, and the {1} "
                                 "of a recording is the reduction of a claim, '{0}: ...'",
                                 function.text, function.text == "min" ? "smallest" : "largest"));
    fail(function, fmt::format("'{}' takes {} value{}, not {}", function.text, arity.least,
                               arity.least == 1 ? "" : "s", values));
  }

  void finish(const Token& end) {
    if (value_comes_) fail(end, "a value is missing at the end");
    if (frames_.size() > 1) fail(frames_.back().open, "'(' without ')'");
    check_questions(frames_.back());
  }

  std::vector<Token> tokens_;
  const Known& known_;
  Program program_;
  std::vector<Frame> frames_;
  std::map<std::uint64_t, std::size_t> numbers_;
  std::map<std::string_view, std::size_t> variables_;
  Prefix prefix_;
  std::size_t at_ = 0;
  bool value_comes_ = true;
};

}  // namespace

Program translate(std::string_view text, const Known& known) {
  if (text.size() > longest_text) {
    throw ExpressionError(fmt::format("an expression has at most {} characters", longest_text), longest_text);
  }
  Program program = Translator(text, known).run();
  check_draws(program, std::vector<std::optional<double>>(program.variables.size()));
  return program;
}

}  // namespace stepwire
