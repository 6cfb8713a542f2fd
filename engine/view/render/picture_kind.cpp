#include "engine/view/render/picture_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::render {

namespace {

constexpr const char* converter = "rsvg-convert";
constexpr std::array<const char*, 3> kind_names{"svg", "png", "pdf"};

std::string name_of(PictureKind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

}  // namespace

std::optional<PictureKind> picture_kind(const std::string& name) {
  const auto known = std::ranges::find(kind_names, name);
  if (known == kind_names.end()) return std::nullopt;
  return static_cast<PictureKind>(known - kind_names.begin());
}

PictureKind picture_kind_of(const std::string& file) {
  if (file.empty()) return PictureKind::svg;
  const std::string ending = std::filesystem::path(file).extension().string();
  if (const auto kind = picture_kind(ending.empty() ? "" : ending.substr(1))) return *kind;
  throw yaml::Error(yaml::Fault{
      {file, {}}, "", fmt::format("a picture is a .svg, .png or .pdf file, not '{}'", ending), {}});
}

std::string picture_kind_names() {
  return fmt::format("{}", fmt::join(kind_names, ", "));
}

std::string ending_of(PictureKind kind) {
  return "." + name_of(kind);
}

std::string converted(const std::string& svg, PictureKind kind, int width) {
  if (kind == PictureKind::svg) return svg;
  require_converter({kind});
  // A PDF contains its time of creation, unless this is set.
  std::vector<std::string> command{"env", "SOURCE_DATE_EPOCH=0", converter, "--format=" + name_of(kind)};
  if (width > 0) command.insert(command.end(), {fmt::format("--width={}", width), "--keep-aspect-ratio"});
  if (width == 0 && kind == PictureKind::png) command.emplace_back("--zoom=2");
  return subprocess::run_helper(converter, {.command = command, .input = svg}).output;
}

std::string converter_problem() {
  if (!subprocess::find_program(converter).empty()) return "";
  return fmt::format("{} is not installed; on Debian it is the package librsvg2-bin", converter);
}

void require_converter(const PictureKinds& kinds) {
  const bool needed = std::ranges::any_of(kinds, [](PictureKind kind) { return kind != PictureKind::svg; });
  if (!needed) return;
  if (const std::string problem = converter_problem(); !problem.empty()) throw io::EnvironmentError(problem);
}

}  // namespace stepwire::render
