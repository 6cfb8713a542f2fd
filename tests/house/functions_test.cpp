#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <regex>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

constexpr std::size_t max_lines = 25;

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The end of what begins here if it is a comment, text or letter; else the same place.
std::size_t end_of_literal(const std::string& code, std::size_t at) {
  const auto behind = [&](const std::string& mark, std::size_t from) {
    const auto found = code.find(mark, from);
    return found == std::string::npos ? code.size() : found + mark.size();
  };
  if (code.compare(at, 2, "//") == 0) return std::min(code.find('\n', at), code.size());
  if (code.compare(at, 2, "/*") == 0) return behind("*/", at + 2);
  if (code.compare(at, 2, "R\"") == 0) {
    const std::size_t open = code.find('(', at);
    return behind(")" + code.substr(at + 2, open - at - 2) + "\"", open);
  }
  const bool separates_digits = at > 0 && std::isalnum(static_cast<unsigned char>(code[at - 1]));
  if (code[at] != '"' && (code[at] != '\'' || separates_digits)) return at;
  std::size_t end = at + 1;
  while (end < code.size() && code[end] != code[at]) end += code[end] == '\\' ? 2 : 1;
  return std::min(end + 1, code.size());
}

/// Code with the lines that it had, but without what may hold braces that are none of its own.
std::string bare(const std::string& code) {
  std::string text;
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t end = end_of_literal(code, at);
    if (end == at) text += code[at];
    if (end > at && (code[at] == '"' || code[at] == 'R')) text += "\"\"";
    for (std::size_t i = at; i < end; ++i)
      if (code[i] == '\n') text += '\n';
    at = std::max(end, at + 1);
  }
  return std::regex_replace(text, std::regex(R"(#[^\n]*)"), "");
}

/// The text between the braces of a block: a function, a lambda or a statement.
struct Body {
  std::size_t line = 0;  ///< of the opening brace
  std::string text;
  std::size_t lines() const {
    const auto breaks = std::count(text.begin(), text.end(), '\n');
    return breaks > 0 ? static_cast<std::size_t>(breaks) - 1 : 0;
  }
};

enum class Brace { scope, block, value };

/// A brace begins a value where clang-format puts no space before it, or behind what awaits a value.
Brace kind_of(const std::string& code, std::size_t at, std::size_t statement) {
  static const std::regex scope(R"(\b(namespace|class|struct|union|enum|extern)\b)");
  static const std::regex awaits_value(R"((^|[=,({[<?&|+]|\breturn)$)");
  if (at == 0 || !is_space(code[at - 1])) return Brace::value;
  std::string head = code.substr(statement, at - statement);
  while (!head.empty() && is_space(head.back())) head.pop_back();
  if (std::regex_search(head.substr(head.size() - std::min<std::size_t>(head.size(), 7)), awaits_value))
    return Brace::value;
  const bool has_arguments = head.find('(') != std::string::npos;
  return !has_arguments && std::regex_search(head, scope) ? Brace::scope : Brace::block;
}

std::vector<Body> bodies_of(const std::string& code) {
  struct Open {
    Brace kind;
    std::size_t at, line;
  };
  std::vector<Body> bodies;
  std::vector<Open> open;
  std::size_t statement = 0, line = 1;
  for (std::size_t at = 0; at < code.size(); ++at) {
    if (code[at] == '\n') ++line;
    if (code[at] == ';') statement = at + 1;
    if (code[at] == '{') {
      open.push_back({kind_of(code, at, statement), at, line});
      if (open.back().kind != Brace::value) statement = at + 1;
    }
    if (code[at] != '}' || open.empty()) continue;
    const Open last = open.back();
    open.pop_back();
    if (last.kind == Brace::block) bodies.push_back({last.line, code.substr(last.at + 1, at - last.at - 1)});
    if (last.kind != Brace::value) statement = at + 1;
  }
  return bodies;
}

/// The statements of a body; those inside of braces and brackets are a part of one.
std::vector<std::string> statements_of(const std::string& body) {
  std::vector<std::string> statements(1);
  int depth = 0;
  for (const char c : body) {
    depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
    if (c == ';' && depth == 0)
      statements.emplace_back();
    else if (!is_space(c) || !statements.back().empty())
      statements.back() += is_space(c) ? ' ' : c;
  }
  if (statements.back().empty()) statements.pop_back();
  return statements;
}

/// A table is rows and nothing else: returned, kept and returned, or declared of a block.
bool is_table(const Body& body) {
  static const std::regex row(
      R"(static const [\w:<>,&* ]+ ?(= )?\{|return (\{|\w+$)|is\.|declare_\w+\(is\b|const std::string \w+ = ""$)");
  const std::vector<std::string> statements = statements_of(body.text);
  return std::ranges::all_of(statements, [](const std::string& one) {
    return std::regex_search(one, row, std::regex_constants::match_continuous);
  });
}

/// Lines at which a body begins that is too long.
std::vector<std::size_t> long_bodies(const std::string& code) {
  std::vector<std::size_t> lines;
  for (const Body& body : bodies_of(bare(code)))
    if (body.lines() > max_lines && !is_table(body)) lines.push_back(body.line);
  return lines;
}

std::size_t indentation_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// Lines of functions in Python whose bodies are too long. A body begins behind the line that ends the head
/// with a colon, and ends with the last line that is indented further than the head.
std::vector<std::size_t> long_functions(const std::vector<std::string>& lines) {
  static const std::regex head(R"( *(async )?def \w+\(.*)"), head_end(R"(.*:\s*(#.*)?)");
  std::vector<std::size_t> found;
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (!std::regex_match(lines[first], head)) continue;
    std::size_t begin = first;
    while (begin + 1 < lines.size() && !std::regex_match(lines[begin], head_end)) ++begin;
    std::size_t last = begin;
    for (std::size_t at = begin + 1; at < lines.size(); ++at) {
      if (lines[at].empty()) continue;
      if (indentation_of(lines[at]) <= indentation_of(lines[first])) break;
      last = at;
    }
    if (last - begin > max_lines) found.push_back(first + 1);
  }
  return found;
}

std::string repeated(const std::string& line, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += line;
  return text;
}

using Lines = std::vector<std::size_t>;

}  // namespace

TEST_CASE("no function has more lines than fit into one view") {
  std::size_t bodies = 0;
  for (const std::string& file : sources_under({"engine", "blocks"})) {
    std::string code;
    for (const Line& line : lines_of(file)) code += line.text + "\n";
    for (const std::size_t line : long_bodies(code)) FAIL_CHECK(file << ":" << line);
    bodies += bodies_of(bare(code)).size();
  }
  CHECK(bodies > 4000);
}

TEST_CASE("a function that is too long is found wherever it stands") {
  const std::string most = repeated("  step();\n", max_lines), more = most + "  step();\n";
  CHECK(long_bodies("void f() {\n" + most + "}\n").empty());
  CHECK(long_bodies("void f() {\n" + more + "}\n") == Lines{1});
  CHECK(long_bodies("namespace a {\nstruct B {\n  B() : c_{1}, d_(2) {\n" + more + "  }\n};\n}\n") ==
        Lines{3});
  CHECK(long_bodies("template <class T>\nstd::vector<T> f(const T& t) const {\n" + more + "}\n") == Lines{2});
  CHECK(long_bodies("const auto f = [] {\n" + more + "};\n") == Lines{1});
  CHECK(long_bodies("void f() {\n  for (;;) {\n" + most + "  }\n}\n") == Lines{1});
  CHECK(long_bodies("void f() {\n" + repeated("  // why }\n", max_lines) + "  step();\n}\n") == Lines{1});
}

TEST_CASE("a class, a text and a table may have more lines than a function") {
  const std::string rows = repeated("      {\"a\", [](int i) { return i; }},\n", max_lines + 1);
  CHECK(
      long_bodies("class A {\n" + repeated("  int f() { return 1'000; }\n", max_lines + 1) + "};\n").empty());
  CHECK(long_bodies("const char* const text = R\"x(f() {\n" + repeated("\"\n", max_lines + 1) + "})x\";\n")
            .empty());
  CHECK(long_bodies("const Rows& f() {\n  static const Rows rows{\n" + rows + "  };\n  return rows;\n}\n")
            .empty());
  CHECK(long_bodies("Rows f() {\n  return {\n" + rows + "  };\n}\n").empty());
  CHECK(long_bodies("void f(Declare& is) {\n" + repeated("  is.input({.doc = \"}\"});\n", max_lines + 1) +
                    "}\n")
            .empty());
}

TEST_CASE("what computes is no table") {
  const std::string more = repeated("  step();\n", max_lines + 1);
  CHECK(long_bodies("int f() {\n  static const int a = [] {\n" + more + "  }();\n  return a;\n}\n").size() ==
        2);
  CHECK(long_bodies("Rows f() {\n  return {{\"a\", [] {\n" + more + "  }}};\n}\n") == Lines{2});
  CHECK(long_bodies("void f(Is& is) {\n  is.a();\n" + repeated("  if (b) is.c();\n", max_lines) + "}\n") ==
        Lines{1});
}

TEST_CASE("no function of the Python module has more lines than fit into one view") {
  std::size_t files = 0;
  for (const std::string& file : all_sources_under({"engine", "blocks"})) {
    if (!file.ends_with(".py")) continue;
    std::vector<std::string> code;
    for (const Line& line : lines_of(file)) code.push_back(line.text);
    for (const std::size_t line : long_functions(code)) FAIL_CHECK(file << ":" << line);
    ++files;
  }
  CHECK(files > 5);
}

TEST_CASE("a long function in Python is found by its indentation") {
  const std::vector<std::string> body(max_lines, "    step()"), deep(max_lines + 1, "        step()");
  const auto joined = [](std::vector<std::string> lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  };
  CHECK(long_functions(joined({"def f(a,", "      b):"}, body)).empty());
  CHECK(long_functions(joined(joined({"def f():"}, body), {"", "", "g()"})).empty());
  CHECK(long_functions(joined(joined({"def f():"}, body), {"", "    g()"})) == Lines{1});
  CHECK(long_functions(joined({"class A:", "    def f(self):"}, deep)) == Lines{2});
}
