#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/expression/binding.hpp"
#include "engine/expression/program.hpp"

namespace stepwire {

/// Makes one thing out of an expression from the inside out. `make` says what a variable, a number, a sign,
/// an operation, a choice and a call become; operations and calls come with their place in the text. The code
/// is known to be right. A value and a sign alternate in it; what waits is on stacks of our own, so that no
/// text can exhaust the real one.
template <class Piece, class Make>
class Fold {
 public:
  Fold(const Program& program, const Make& make) : program_(program), make_(make), rest_(program.code) {}

  Piece run() {
    waiting_.push_back({{}, Binding::open});
    while (!rest_.empty()) {
      if (rest_.front() == ' ') {
        take(1);
      } else {
        value_comes_ ? value() : sign();
      }
    }
    settle(Binding::condition);
    return std::move(pieces_.back());
  }

 private:
  /// An operator, a sign or a parenthesis that waits for what follows.
  struct Waiting {
    std::string_view sign;  ///< of a parenthesis: its function, if it has one
    Binding binding;
    std::size_t place = 0;  ///< in the text
    std::size_t first = 0;  ///< piece in a parenthesis
  };

  /// Longer signs before those that they begin with.
  static constexpr std::array<std::pair<std::string_view, Binding>, 13> operators{
      {{"||", Binding::either},
       {"&&", Binding::both},
       {"<=", Binding::comparison},
       {">=", Binding::comparison},
       {"==", Binding::comparison},
       {"!=", Binding::comparison},
       {"<", Binding::comparison},
       {">", Binding::comparison},
       {"+", Binding::sum},
       {"-", Binding::sum},
       {"*", Binding::product},
       {"/", Binding::product},
       {"^", Binding::power}}};

  /// A program has one sign for each run of signs.
  static constexpr std::array<std::pair<char, std::string_view>, 5> runs{
      {{'-', "-"}, {'!', "!"}, {'~', "!!"}, {'#', "-!"}, {'$', "-!!"}}};

  static bool is_of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

  std::string_view take(std::size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }

  std::size_t next_place() { return program_.places[next_place_++]; }

  void value() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_of_word);
    const std::string_view word = take(static_cast<std::size_t>(end - rest_.begin()));
    if (rest_.starts_with('(')) {
      waiting_.push_back({word, Binding::open, word.empty() ? 0 : next_place(), pieces_.size()});
      take(1);
    } else if (word.empty()) {
      signs(take(1).front());
    } else {
      operand(word);
    }
  }

  void signs(char code) {
    const auto found =
        std::find_if(runs.begin(), runs.end(), [&](const auto& run) { return run.first == code; });
    const std::string_view run = found->second;
    for (std::size_t i = 0; i < run.size(); ++i) waiting_.push_back({run.substr(i, 1), Binding::prefix});
  }

  /// v3 or c12
  void operand(std::string_view name) {
    std::size_t index = 0;
    std::from_chars(name.data() + 1, name.data() + name.size(), index);
    pieces_.push_back(name.front() == 'v' ? make_.variable(index) : make_.number(index));
    value_comes_ = false;
  }

  void sign() {
    const char first = rest_.front();
    if (first == ')' || first == ',') settle(Binding::condition);
    if (first == ')') return close();
    value_comes_ = true;
    if (first == ':') return answer();
    if (first == '?') return wait(take(1), Binding::condition, Binding::either, 0);
    first == ',' ? void(take(1)) : operation();
  }

  void operation() {
    const auto found = std::find_if(operators.begin(), operators.end(),
                                    [&](const auto& known) { return rest_.starts_with(known.first); });
    const auto [sign, binding] = *found;
    wait(take(sign.size()), binding, binding == Binding::power ? Binding::atom : binding, next_place());
  }

  /// What binds at least so strongly has its right operand now.
  void wait(std::string_view sign, Binding binding, Binding settled, std::size_t place) {
    settle(settled);
    waiting_.push_back({sign, binding, place});
  }

  void answer() {
    while (waiting_.back().sign != "?") apply();
    waiting_.back().sign = take(1);
  }

  void close() {
    take(1);
    const Waiting opened = waiting_.back();
    waiting_.pop_back();
    if (!opened.sign.empty())
      pieces_.push_back(make_.call(opened.sign, take_pieces(pieces_.size() - opened.first), opened.place));
  }

  void settle(Binding least) {
    while (waiting_.back().binding >= least) apply();
  }

  void apply() {
    const Waiting top = waiting_.back();
    waiting_.pop_back();
    const std::size_t count = top.binding == Binding::prefix ? 1 : top.binding == Binding::condition ? 3 : 2;
    const std::vector<Piece> of = take_pieces(count);
    pieces_.push_back(count == 1   ? make_.sign(top.sign, of[0])
                      : count == 2 ? make_.operation(top.sign, top.binding, of[0], of[1], top.place)
                                   : make_.choice(of[0], of[1], of[2]));
  }

  std::vector<Piece> take_pieces(std::size_t count) {
    const auto first = pieces_.end() - static_cast<std::ptrdiff_t>(count);
    std::vector<Piece> taken(std::make_move_iterator(first), std::make_move_iterator(pieces_.end()));
    pieces_.erase(first, pieces_.end());
    return taken;
  }

  const Program& program_;
  const Make& make_;
  std::string_view rest_;
  std::vector<Piece> pieces_;
  std::vector<Waiting> waiting_;
  std::size_t next_place_ = 0;
  bool value_comes_ = true;
};

}  // namespace stepwire
