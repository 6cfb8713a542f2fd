#include <catch2/catch.hpp>

#include "engine/app/language/file_uri.hpp"
#include "engine/app/language/message_frames.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

TEST_CASE("editors count units of UTF-16, of which a character beyond 0xffff has two") {
  const std::string text = "a\t\u03a9\U0001f600b\r\nc\n";
  TextPlaces places(text);
  CHECK(places.offset(EditorPosition{0, 3}) == 4);
  CHECK(places.offset(EditorPosition{0, 4}) == 4);  // between the halves of one character
  CHECK(places.offset(EditorPosition{0, 5}) == 8);
  CHECK(places.offset(EditorPosition{0, 99}) == 9);  // before the line end of Windows
  CHECK(places.offset(EditorPosition{1, 1}) == 12);
  CHECK(places.offset(EditorPosition{99, 0}) == text.size());
  for (std::size_t at : {0u, 2u, 4u, 8u, 9u, 11u, 12u}) CHECK(places.offset(places.position(at)) == at);
}

TEST_CASE("a splice of a value is refused where more of the file would change") {
  const std::string text = "a: 1 # x\nb: {c: d}\ne: 'f'\n";
  const auto put = [&](const std::string& word, const std::string& by) {
    const std::size_t at = text.find(word);
    return spliced_values(text, {{{at, at + word.size()}, by}});
  };
  CHECK(put("1", "2 mm") == "a: 2 mm # x\nb: {c: d}\ne: 'f'\n");
  CHECK(put("c", "g.h") == "a: 1 # x\nb: {g.h: d}\ne: 'f'\n");
  for (const std::string by : {"x, y: z", "}", "{", "# d", "d: e", "'d", "[d", ""})
    CHECK_THROWS_AS(put("d", by), EditRefused);
  CHECK_THROWS_AS(put("1", "2\nk: 3"), EditRefused);
  CHECK_THROWS_AS(put("b:", "a:"), EditRefused);
  CHECK_THROWS_AS(put("# x", "2"), EditRefused);
  CHECK_THROWS_AS(put("f", "g'h"), EditRefused);
}

TEST_CASE("several splices are put at once, and two of one place are refused") {
  CHECK(spliced("abcdef", {{{4, 5}, "X"}, {{1, 2}, ""}, {{6, 6}, "!"}}) == "acdXf!");
  CHECK_THROWS_AS(spliced("abc", {{{0, 2}, "x"}, {{1, 3}, "y"}}), EditRefused);
}

TEST_CASE("a file's URI and path lead to one another, whatever is in the name") {
  for (const std::string path : {"/a/b.yaml", "/with blank/\u03a9#?%41.yaml"})
    CHECK(path_of_uri(uri_of_path(path)) == path);
  CHECK(path_of_uri("file:///a/%C3%A4%20b/../c.yaml") == "/a/c.yaml");
  CHECK(path_of_uri("untitled:one") == "untitled:one");
  CHECK(path_of_uri("file:///100%") == "/100%");
}

TEST_CASE("addresses may be those of a page that knows numbers for paths") {
  FileUris uris([](const std::string& uri) { return uri == "studio:/3" ? "/a/b.yaml" : ""; },
                [](const std::string& path) { return path == "/a/c.yaml" ? "studio:/4" : ""; });
  CHECK(uris.path("studio:/3") == "/a/b.yaml");
  CHECK(uris.path("studio:/9").empty());
  CHECK(uris.uri("/a/b.yaml") == "studio:/3");
  CHECK(uris.uri("/a/c.yaml") == "studio:/4");
  CHECK(uris.uri("").empty());
}

TEST_CASE("messages come in frames, however their bytes are cut") {
  const std::string all = framed("{\"a\": \"\u03a9\"}") + "X: y\r\ncontent-length: 2\r\n\r\n{}" + framed("");
  for (std::size_t most = 1; most < 40; ++most) {
    std::size_t at = 0;
    FrameReader reader([&](char* to, std::size_t room) {
      const std::size_t count = std::min({most, room, all.size() - at});
      all.copy(to, count, at);
      at += count;
      return count;
    });
    CHECK(reader.next() == "{\"a\": \"\u03a9\"}");
    CHECK(reader.next() == "{}");
    CHECK(reader.next() == "");
    CHECK(reader.next() == std::nullopt);
  }
}

}  // namespace stepwire::language
