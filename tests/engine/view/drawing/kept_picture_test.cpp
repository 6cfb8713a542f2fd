// A picture that has been laid out once is not laid out again.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "blocks/register.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/drawing/draw.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::drawing {

namespace {

/// Uses a folder as the cache, and the former one again afterwards.
class CacheOfTest {
 public:
  explicit CacheOfTest(const std::string& folder) { ::setenv(name, folder.c_str(), 1); }
  ~CacheOfTest() { had_ ? ::setenv(name, before_.c_str(), 1) : ::unsetenv(name); }
  CacheOfTest(const CacheOfTest&) = delete;
  CacheOfTest& operator=(const CacheOfTest&) = delete;

 private:
  static constexpr const char* name = "STEPWIRE_CACHE";
  const bool had_ = std::getenv(name) != nullptr;
  const std::string before_ = had_ ? std::getenv(name) : "";
};

/// The graph of a chain of a source and a gain.
json::Json graph_of_gain(const std::string& gain) {
  const Scratch folder;
  const std::string file =
      folder.file("gain.yaml",
                  "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  a: {block: Constant, value: 1}\n"
                  "  b: {block: Gain, u: a, gain: " +
                      gain + "}\nrecord: [b]\n");
  const Registry registry = blocks();
  diagram::Loader loader(registry);
  return DrawnFile(loader, file).view().graph({});
}

}  // namespace

TEST_CASE("The same diagram is drawn once and then taken from the cache, another one is drawn") {
  const Scratch folder;
  const CacheOfTest cache(folder.path("new"));
  const std::string drawn = draw_picture(graph_of_gain("2"));
  CHECK(drawn.find("<svg") != std::string::npos);
  const std::filesystem::directory_iterator kept(folder.path("new"));
  CHECK(io::read_file(kept->path().string()).starts_with(drawn));
  io::Cache(folder.path("new")).keep(kept->path().filename().string(), "as it was");
  CHECK(draw_picture(graph_of_gain("2")) == "as it was");
  CHECK(draw_picture(graph_of_gain("3")).find("<svg") != std::string::npos);
}

TEST_CASE("A picture that was damaged in the cache is drawn anew") {
  const Scratch folder;
  const CacheOfTest cache(folder.path("new"));
  const std::string drawn = draw_picture(graph_of_gain("2"));
  const std::filesystem::directory_iterator kept(folder.path("new"));
  std::filesystem::resize_file(kept->path(), 100);
  CHECK(draw_picture(graph_of_gain("2")) == drawn);
}

TEST_CASE("Where nothing can be kept a diagram is drawn all the same") {
  const Scratch folder;
  const CacheOfTest cache(folder.file("file", "") + "/below");
  CHECK(draw_picture(graph_of_gain("2")).find("<svg") != std::string::npos);
}

}  // namespace stepwire::drawing
