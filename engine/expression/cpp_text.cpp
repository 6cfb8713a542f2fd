#include "engine/expression/cpp_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/expression/cpp_piece.hpp"

namespace stepwire {
namespace {

/// Longer signs before those that they begin with.
constexpr std::array<std::pair<std::string_view, Binding>, 13> operators{{{"||", Binding::either},
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
constexpr std::array<std::pair<char, std::string_view>, 5> runs{
    {{'-', "-"}, {'!', "!"}, {'~', "!!"}, {'#', "-!"}, {'$', "-!!"}}};

bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

/// An operator, a sign or a parenthesis that waits for what follows.
struct Waiting {
  std::string_view sign;  ///< of a parenthesis: its function, if it has one
  Binding binding;
  std::size_t first = 0;  ///< piece in a parenthesis
};

/// Reads the code of a program, which is known to be right. A value and a sign alternate; what waits is on
/// stacks of our own, so that no text can exhaust the real one.
class Writer {
 public:
  Writer(const Program& program, const VariableText& variable)
      : program_(program), variable_(variable), rest_(program.code) {}

  CppPiece run() {
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
  std::string_view take(std::size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }

  void value() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_of_word);
    const std::string_view word = take(static_cast<std::size_t>(end - rest_.begin()));
    if (rest_.starts_with('(')) {
      waiting_.push_back({word, Binding::open, pieces_.size()});
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
    pieces_.push_back(name.front() == 'v' ? CppPiece{variable_(index)} : cpp_number(program_.numbers[index]));
    value_comes_ = false;
  }

  void sign() {
    const char first = rest_.front();
    if (first == ')' || first == ',') settle(Binding::condition);
    if (first == ')') return close();
    value_comes_ = true;
    if (first == ':') return answer();
    if (first == '?') return wait(take(1), Binding::condition, Binding::either);
    first == ',' ? void(take(1)) : operation();
  }

  void operation() {
    const auto found = std::find_if(operators.begin(), operators.end(),
                                    [&](const auto& known) { return rest_.starts_with(known.first); });
    const auto [sign, binding] = *found;
    wait(take(sign.size()), binding, binding == Binding::power ? Binding::atom : binding);
  }

  /// What binds at least so strongly has its right operand now.
  void wait(std::string_view sign, Binding binding, Binding settled) {
    settle(settled);
    waiting_.push_back({sign, binding});
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
      pieces_.push_back(cpp_call(opened.sign, take_pieces(pieces_.size() - opened.first)));
  }

  void settle(Binding least) {
    while (waiting_.back().binding >= least) apply();
  }

  void apply() {
    const auto [sign, binding, first] = waiting_.back();
    waiting_.pop_back();
    const std::size_t count = binding == Binding::prefix ? 1 : binding == Binding::condition ? 3 : 2;
    const std::vector<CppPiece> of = take_pieces(count);
    pieces_.push_back(count == 1   ? cpp_sign(sign, of[0])
                      : count == 2 ? cpp_operation(sign, binding, of[0], of[1])
                                   : cpp_choice(of[0], of[1], of[2]));
  }

  std::vector<CppPiece> take_pieces(std::size_t count) {
    const auto first = pieces_.end() - static_cast<std::ptrdiff_t>(count);
    std::vector<CppPiece> taken(std::make_move_iterator(first), std::make_move_iterator(pieces_.end()));
    pieces_.erase(first, pieces_.end());
    return taken;
  }

  const Program& program_;
  const VariableText& variable_;
  std::string_view rest_;
  std::vector<CppPiece> pieces_;
  std::vector<Waiting> waiting_;
  bool value_comes_ = true;
};

}  // namespace

std::string cpp_text(const Program& program, const VariableText& variable) {
  return Writer(program, variable).run().text;
}

std::string cpp_condition_text(const Program& program, const VariableText& variable) {
  return cpp_truth(Writer(program, variable).run()).text;
}

}  // namespace stepwire
