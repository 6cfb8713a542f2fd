#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "engine/app/session/monitor.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Which figures of the thesis are made, and where.
struct ThesisCall {
  std::vector<std::string> only;  ///< beginnings of file names: "fig15"; empty: all
  std::string diagrams;           ///< folder with the diagram files
  std::string out = "out/thesis";
};

/// One diagram file of the thesis, made or not.
struct ThesisFigure {
  gallery::GalleryEntry entry;
  session::Outcome outcome;  ///< without its recordings
  std::exception_ptr error;  ///< why it was not made; null where it was
};

/// Makes the figures, several at a time; `made` gets each once it is done, from any thread but one at a time.
/// Then writes the pages, unless interrupted with chapters as PDF, and returns the entries in the order of
/// the thesis; the first page is `out`/index.html. Throws EnvironmentError; Error where no file begins as
/// `only` says.
std::vector<gallery::GalleryEntry> make_thesis(const ThesisCall& call, const Registry& registry,
                                               const session::Monitor& monitor,
                                               const std::function<void(const ThesisFigure&)>& made);

}  // namespace stepwire::thesis
