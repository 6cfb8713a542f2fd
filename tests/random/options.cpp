#include "tests/random/options.hpp"

#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>

namespace stepwire::random {

namespace {

using Setters = std::map<std::string, std::function<void(Options&, const std::string&)>>;

std::uint64_t whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    throw std::invalid_argument("'" + text + "' is no whole number");
  return number;
}

const Setters& flags() {
  static const Setters all{{"--forever", [](Options& o, const std::string&) { o.forever = true; }},
                           {"--show", [](Options& o, const std::string&) { o.show = true; }},
                           {"--keep-size", [](Options& o, const std::string&) { o.shrinks = false; }},
                           {"--help", [](Options& o, const std::string&) { o.help = true; }},
                           {"-h", [](Options& o, const std::string&) { o.help = true; }}};
  return all;
}

const Setters& values() {
  static const Setters all{
      {"--seed", [](Options& o, const std::string& text) { o.seed = whole_number(text); }},
      {"--count", [](Options& o, const std::string& text) { o.count = whole_number(text); }},
      {"--with-code", [](Options& o, const std::string& text) { o.with_code = whole_number(text); }},
      {"--out", [](Options& o, const std::string& text) { o.out = text; }}};
  return all;
}

}  // namespace

Options read_options(int count, const char* const* arguments) {
  Options options;
  for (int i = 0; i < count; ++i) {
    const std::string name = arguments[i];
    if (const auto flag = flags().find(name); flag != flags().end()) {
      flag->second(options, "");
      continue;
    }
    const auto value = values().find(name);
    if (value == values().end()) throw std::invalid_argument("unknown option '" + name + "'; see --help");
    if (i + 1 == count) throw std::invalid_argument("give a value behind " + name);
    value->second(options, arguments[++i]);
  }
  if (options.count == 0) throw std::invalid_argument("--count is at least 1");
  return options;
}

std::string help_text() {
  return R"(Tries laws on random diagrams; tests/README.md lists them.
  --count N        diagrams; 300 where it is left out
  --seed S         seed of the first diagram; the next one has S + 1
  --with-code N    diagrams of them that are compiled as well, from the first on; all where it is left out
  --forever        tries --count diagrams after --count diagrams until a law is broken
  --keep-size      keeps a diagram that breaks a law as it is
  --out FOLDER     folder of such diagrams, random-failures where it is left out
  --show           writes the diagram of --seed into that folder, prints it, and tries nothing
Exit status: 0 if all laws held, 1 if not, 2 for a wrong command line.
)";
}

}  // namespace stepwire::random
