#include <algorithm>
#include <cstdint>
#include <string>

#include "blocks/register.hpp"
#include "engine/app/language/language_server.hpp"

using namespace stepwire;

// Each line is a message of an editor. The server handles any message without a crash.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Registry registry = blocks();
  language::LanguageServer server(registry, [](const std::string&) {});
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    server.post(text.substr(begin, end - begin));
    begin = end + 1;
  }
  server.close();
  server.run();
  return 0;
}
