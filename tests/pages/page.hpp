#pragma once

#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

/// A block of code, between two lines of three backquotes.
struct Fence {
  std::string language;  ///< the word behind the backquotes
  Line first;            ///< its first line, for messages
  std::string text;
  std::string lead;  ///< the paragraph before it
};

/// A file of Markdown, split into its blocks of code and the text outside of these.
struct Page {
  std::string file;  ///< path from the top of the source tree
  std::vector<Line> prose;
  std::vector<Fence> fences;
};

/// Every page of the source tree.
std::vector<Page> all_pages();

/// The prose in paragraphs, each as one line.
std::vector<std::string> paragraphs_of(const Page& page);

/// Returns the pieces of a text between single backquotes.
std::vector<std::string> code_in(const std::string& text);

/// All code of a page: fences and pieces of the prose.
std::string all_code_of(const Page& page);

/// The targets of the links of a text, those to other hosts left out.
std::vector<std::string> links_in(const std::string& text);

/// Where a link from a page leads to, from the top of the source tree, without what follows '#'.
std::string target_of(const Page& page, const std::string& link);

/// The anchors that the headings of a page get on the usual hosts: "#a-first-diagram".
std::vector<std::string> anchors_of(const Page& page);
