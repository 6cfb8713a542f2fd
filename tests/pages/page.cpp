#include "tests/pages/page.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

namespace {

const std::string quotes = "```";

std::vector<std::string> found_in(const std::string& text, const std::regex& what) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), what), none; at != none; ++at)
    found.push_back(at->str(1));
  return found;
}

/// The last lines of the prose that follow each other, without those that are empty at its end.
std::string last_paragraph(const std::vector<Line>& prose) {
  std::string paragraph;
  for (auto line = prose.rbegin(); line != prose.rend(); ++line) {
    if (!line->text.empty()) paragraph = line->text + (paragraph.empty() ? "" : " ") + paragraph;
    if (line->text.empty() && !paragraph.empty()) break;
  }
  return paragraph;
}

Page page_of(const std::string& file) {
  Page page{file, {}, {}};
  bool inside = false;
  for (const Line& line : lines_of(file)) {
    if (line.text.starts_with(quotes)) {
      inside = !inside;
      if (inside)
        page.fences.push_back({line.text.substr(quotes.size()), line, "", last_paragraph(page.prose)});
    } else if (inside) {
      page.fences.back().text += line.text + "\n";
    } else {
      page.prose.push_back(line);
    }
  }
  return page;
}

}  // namespace

std::vector<Page> all_pages() {
  std::vector<Page> pages;
  for (const std::string& file : files_under(""))
    if (file.ends_with(".md")) pages.push_back(page_of(file));
  return pages;
}

std::vector<std::string> paragraphs_of(const Page& page) {
  std::vector<std::string> paragraphs{""};
  for (const Line& line : page.prose) {
    if (line.text.empty())
      paragraphs.emplace_back();
    else
      paragraphs.back() += (paragraphs.back().empty() ? "" : " ") + line.text;
  }
  return paragraphs;
}

std::vector<std::string> code_in(const std::string& text) {
  return found_in(text, std::regex("`([^`]+)`"));
}

std::string all_code_of(const Page& page) {
  std::string code;
  for (const Fence& fence : page.fences) code += fence.text;
  for (const std::string& paragraph : paragraphs_of(page))
    for (const std::string& piece : code_in(paragraph)) code += piece + "\n";
  return code;
}

std::vector<std::string> links_in(const std::string& text) {
  std::vector<std::string> links;
  for (const std::string& link : found_in(text, std::regex(R"(\]\(([^)\s]+)\))")))
    if (link.find("://") == std::string::npos) links.push_back(link);
  return links;
}

std::string target_of(const Page& page, const std::string& link) {
  const std::string path = link.substr(0, link.find('#'));
  if (path.empty()) return page.file;
  const std::string target = (std::filesystem::path(folder_of(page.file)) / path).lexically_normal().string();
  return target.ends_with('/') ? target.substr(0, target.size() - 1) : target;
}

std::vector<std::string> anchors_of(const Page& page) {
  std::vector<std::string> anchors;
  for (const Line& line : page.prose) {
    if (!line.text.starts_with('#')) continue;
    std::string anchor = "#";
    for (const char c : line.text.substr(line.text.find(' ') + 1)) {
      const auto letter = static_cast<unsigned char>(c);
      if (std::isalnum(letter) || c == '-' || c == '_') anchor += static_cast<char>(std::tolower(letter));
      if (c == ' ') anchor += '-';
    }
    anchors.push_back(anchor);
  }
  return anchors;
}
