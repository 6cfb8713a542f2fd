#include "engine/view/drawing/symbol_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <map>

namespace stepwire::drawing {

namespace {

constexpr std::size_t max_letters = 16, max_letters_of_polynomial = 28;

const std::map<std::string, std::string, std::less<>> letters{{"alpha", "α"},
                                                              {"beta", "β"},
                                                              {"gamma", "γ"},
                                                              {"delta", "δ"},
                                                              {"epsilon", "ε"},
                                                              {"zeta", "ζ"},
                                                              {"eta", "η"},
                                                              {"theta", "θ"},
                                                              {"kappa", "κ"},
                                                              {"lambda", "λ"},
                                                              {"mu", "μ"},
                                                              {"nu", "ν"},
                                                              {"pi", "π"},
                                                              {"rho", "ρ"},
                                                              {"sigma", "σ"},
                                                              {"tau", "τ"},
                                                              {"phi", "φ"},
                                                              {"psi", "ψ"},
                                                              {"omega", "ω"},
                                                              {"less", "<"},
                                                              {"greater", ">"},
                                                              {"less_equal", "≤"},
                                                              {"greater_equal", "≥"},
                                                              {"equal", "="},
                                                              {"not_equal", "≠"}};
const std::map<std::string, std::string, std::less<>> signs{
    {"<=", "≤"}, {">=", "≥"}, {"==", "="}, {"!=", "≠"}};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

const std::array<const char*, 10> superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

/// Appends the typographic sign for an ASCII sign at the beginning of a text. Returns the length of the ASCII
/// sign.
std::size_t append_sign(std::string_view text, std::string& result) {
  const auto sign = signs.find(text.substr(0, 2));
  if (sign != signs.end()) return result += sign->second, 2;
  const auto is_digit = [&](std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
  };
  if (text[0] == '^' && is_digit(1) && !is_digit(2) && !text.substr(2).starts_with('.'))
    return result += superscripts[static_cast<std::size_t>(text[1] - '0')], 2;
  result += text[0] == '-' ? "−" : text[0] == '*' ? "·" : std::string(1, text[0]);
  return 1;
}

/// Replaces names of Greek letters, and ASCII signs by typographic ones.
std::string typeset(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    if (end > at) {
      const std::string_view word = text.substr(at, end - at);
      const auto letter = letters.find(word);
      result += letter == letters.end() ? word : letter->second;
      at = end;
    } else {
      at += append_sign(text.substr(at), result);
    }
  }
  return result;
}

std::size_t length(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  return count;
}

/// Returns "0.25", "−3", "10⁻⁵".
std::string number_text(double number) {
  const std::string text = fmt::format("{:.4g}", number);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return typeset(text);
  const int exponent = std::stoi(text.substr(e + 1));
  std::string power = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    power += superscripts[static_cast<std::size_t>(digit - '0')];
  const std::string factor = text.substr(0, e);
  return factor == "1" ? power : typeset(factor) + "·" + power;
}

std::string power(std::size_t exponent, std::string_view variable) {
  if (exponent == 0) return {};
  std::string text(variable);
  if (exponent > 1)
    for (const char digit : std::to_string(exponent))
      text += superscripts[static_cast<std::size_t>(digit - '0')];
  return text;
}

/// Returns "s² + 2 s + 25" for [1, 2, 25].
std::string polynomial(const Eigen::VectorXd& coefficients, std::string_view variable) {
  std::string text;
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    const double value = coefficients[i];
    const auto exponent = static_cast<std::size_t>(coefficients.size() - 1 - i);
    if (value == 0.0) continue;
    text += text.empty() ? (value < 0.0 ? "−" : "") : (value < 0.0 ? " − " : " + ");
    const double size = std::abs(value);
    if (exponent == 0 || size != 1.0) text += number_text(size) + (exponent > 0 ? " " : "");
    text += power(exponent, variable);
  }
  return text.empty() ? "0" : text;
}

/// Fills in the placeholders of a block's symbol.
class Filler {
 public:
  Filler(const diagram::DiagramBlock& block, const yaml::Node& written, bool fraction)
      : block_(block), written_(written), fraction_(fraction) {}

  std::string fill(std::string_view text) const {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] != '{') {
        result += text[at++];
        continue;
      }
      const std::size_t end = text.find('}', at);
      result += place(text.substr(at + 1, end - at - 1));
      at = end + 1;
      if (result.ends_with('1') && (result.size() == 1) && text.substr(at).starts_with(" s"))
        result.pop_back(), ++at;  // "s + 1", not "1 s + 1"
    }
    return result;
  }

 private:
  std::string place(std::string_view text) const {
    const std::size_t bar = text.find('|'), colon = text.find(':');
    const std::string name(text.substr(0, std::min(bar, colon)));
    const ParameterSpec& spec = *block_.type().parameter(name);
    const Value value = spec.get(block_.block.get());
    const bool is_polynomial = colon != std::string_view::npos;
    const std::string filled =
        is_polynomial ? polynomial(std::get<Eigen::VectorXd>(value.content), text.substr(colon + 1, 1))
                      : parameter(spec, value);
    const bool fits =
        !filled.empty() && length(filled) <= (is_polynomial ? max_letters_of_polynomial : max_letters);
    return fits || bar == std::string_view::npos ? filled : std::string(text.substr(bar + 1));
  }

  std::string parameter(const ParameterSpec& spec, const Value& value) const {
    if (spec.kind == ParameterKind::file) return std::filesystem::path(*value.text()).filename().string();
    const yaml::Node* node = written_.find(spec.name);
    const bool named = node && node->is_scalar() && !node->quoted && !node->text.empty() &&
                       (node->text.front() == '$' || node->text.front() == '=');
    if (node && (named || !fraction_)) return as_written(*node, spec);
    if (const double* number = std::get_if<double>(&value.content)) return number_text(*number);
    if (const auto* numbers = std::get_if<Eigen::VectorXd>(&value.content))
      return numbers->size() == 1 ? number_text((*numbers)[0]) : std::string();
    return value.text() ? word(*value.text()) : std::string();
  }

  static std::string as_written(const yaml::Node& node, const ParameterSpec& spec) {
    return spec.kind == ParameterKind::word ? word(node.text) : printed_value(node);
  }

  static std::string word(const std::string& text) {
    const auto sign = signs.find(text);
    return sign != signs.end() ? sign->second : typeset(text);
  }

  const diagram::DiagramBlock& block_;
  const yaml::Node& written_;
  bool fraction_;
};

/// Returns "MR", "Damper" for MRDamper.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words{""};
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto upper = [&](std::size_t at) {
      return std::isupper(static_cast<unsigned char>(name[at])) != 0;
    };
    const bool starts = i > 0 && upper(i) && (!upper(i - 1) || (i + 1 < name.size() && !upper(i + 1)));
    if (starts && !words.back().empty()) words.emplace_back();
    words.back() += name[i];
  }
  return words;
}

}  // namespace

std::string printed_value(const yaml::Node& node) {
  if (node.is_list()) {
    std::vector<std::string> items;
    for (const yaml::Node& item : node.items) items.push_back(printed_value(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  if (const yaml::Node* value = node.is_map() ? node.find("value") : nullptr) {
    const yaml::Node* unit = node.find("unit");
    return printed_value(*value) + (unit ? " " + unit->text : "");
  }
  if (node.is_map()) {  // a bus
    std::vector<std::string> fields;
    for (const yaml::Entry& field : node.entries)
      fields.push_back(field.key + ": " + printed_value(field.value));
    return fmt::format("{{{}}}", fmt::join(fields, ", "));
  }
  const std::size_t start = node.text.find_first_not_of("=$ ");
  return typeset(start == std::string::npos ? std::string_view() : std::string_view(node.text).substr(start));
}

SymbolText symbol_text(const diagram::DiagramBlock& block, const yaml::Node& written) {
  const Symbol& symbol = block.type().symbol;
  SymbolText result;
  if (symbol.text.empty()) {
    if (symbol.curve.empty() && symbol.outline == Symbol::Outline::box)
      result.lines = words_of(block.type().name);
    return result;
  }
  const std::size_t bar = symbol.text.find(" / ");
  result.fraction = bar != std::string::npos;
  const Filler filler(block, written, result.fraction);
  if (result.fraction) {
    result.lines = {filler.fill(std::string_view(symbol.text).substr(0, bar)),
                    filler.fill(std::string_view(symbol.text).substr(bar + 3))};
    return result;
  }
  for (std::size_t at = 0; at <= symbol.text.size();) {
    const std::size_t end = std::min(symbol.text.find('\n', at), symbol.text.size());
    result.lines.push_back(filler.fill(std::string_view(symbol.text).substr(at, end - at)));
    at = end + 1;
  }
  return result;
}

std::string sample_time_text(const diagram::DiagramBlock& block, const yaml::Node& written) {
  const yaml::Node* const every = written.find("every");
  if (!every || !block.every) return "";
  const auto text_of = [](const yaml::Node* node, double seconds) {
    const bool plain = node && node->is_scalar() && node->text.find_first_of("$=") == std::string::npos;
    if (plain) return node->text;
    return seconds < 1.0 ? fmt::format("{:g} ms", 1e3 * seconds) : fmt::format("{:g} s", seconds);
  };
  if (every->is_scalar()) return text_of(every, block.every->period);
  const std::string period = text_of(every->find("period"), block.every->period);
  if (block.every->offset == 0.0) return period;
  return period + " + " + text_of(every->find("offset"), block.every->offset);
}

}  // namespace stepwire::drawing
