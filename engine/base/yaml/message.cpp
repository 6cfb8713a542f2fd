#include "engine/base/yaml/message.hpp"

namespace stepwire::yaml {

Message::Message(const std::string& text) : wrong(text) {
  bool quoted = false;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '\'') quoted = !quoted;
    if (quoted || text[i] != ';' || text[i + 1] != ' ') continue;
    wrong.resize(i);
    cure = text.substr(i + 2);
    return;
  }
}

Message& Message::operator+=(const std::string& more) {
  (cure.empty() ? wrong : cure) += more;
  return *this;
}

Message operator+(const std::string& what, Message rest) {
  rest.wrong.insert(0, what);
  return rest;
}

Message parted_at(char mark, const std::string& text) {
  const std::size_t at = text.find(mark);
  return at == text.npos ? Message(text, "") : Message(text.substr(0, at), text.substr(at + 1));
}

}  // namespace stepwire::yaml
