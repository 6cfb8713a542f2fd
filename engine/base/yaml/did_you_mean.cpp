#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "engine/base/text/nearest.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

Message did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string* const nearest = text::nearest(word, names);
  if (!nearest) return {};
  return {"", "did you mean '" + *nearest + "'?", Suggestion{word, *nearest}};
}

Message did_you_mean(const std::string& word, const std::vector<std::string>& names,
                     const std::string& sentence) {
  Message message = did_you_mean(word, names);
  message += (message.empty() ? ". " : " ") + sentence;
  return message;
}

Message nearest_or_all(const std::string& word, const std::vector<std::string>& names, std::string what) {
  constexpr std::size_t most = 24;
  Message message = did_you_mean(word, names);
  if (!message.empty())
    what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size()));
  const std::string all =
      fmt::format("{}: {}{}", what, fmt::join(names.begin(), end, ", "), names.size() > most ? ", ..." : "");
  message.cure += message.cure.empty() ? all : " " + all;
  return message;
}

Message unknown_key(const std::string& key, const std::vector<std::string>& known, const std::string& owner) {
  const std::string message = fmt::format("{} has no '{}'", owner, key);
  if (key.find_first_of("()+*/<>=&|?$") != std::string::npos)
    return {message,
            "it looks like a piece of an expression: put an expression with a comma or a colon in quotes"};
  if (key.find(' ') != std::string::npos)
    return {message, "it looks like a piece of a sentence: put a text with a comma or a colon in quotes"};
  return message + nearest_or_all(key, known, "it has");
}

}  // namespace stepwire::yaml
