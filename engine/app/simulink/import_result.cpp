#include "engine/app/simulink/import_result.hpp"

#include <algorithm>

namespace stepwire::simulink {

const char* word_of(NoteKind kind) {
  switch (kind) {
    case NoteKind::placeholder:
      return "placeholder";
    case NoteKind::missing:
      return "missing";
    case NoteKind::deviates:
      return "deviates";
    case NoteKind::renamed:
      return "renamed";
    case NoteKind::fault:
      return "fault";
    default:
      return "differs";
  }
}

std::size_t ImportResult::count(NoteKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(notes, kind, &Note::kind));
}

bool ImportResult::is_unfinished() const {
  return count(NoteKind::placeholder) + count(NoteKind::missing) + count(NoteKind::deviates) +
             count(NoteKind::fault) >
         0;
}

static void declare(result::Record<Note>& is) {
  is.named("ImportNote", "One sentence on a difference between the model and the written diagram.");
  is.field(
      "kind", [](const Note& of) { return word_of(of.kind); },
      "placeholder, missing, deviates, differs, renamed or fault");
  is.field("block", &Note::block, "path of the block in the model; empty for the model itself");
  is.field("sentence", &Note::sentence, "what is not translated, and what to do");
}

void declare(result::Record<ImportResult>& is) {
  is.named("ImportResult", "A diagram made of a Simulink model.");
  is.field("model", &ImportResult::model, "file of the model");
  is.field("files", &ImportResult::files, "written files, the diagram first");
  is.field("blocks", &ImportResult::blocks, "blocks of the model");
  is.field("translated", &ImportResult::translated, "blocks with a counterpart");
  is.field(
      "finished", [](const ImportResult& of) { return !of.is_unfinished(); },
      "false where placeholders, missing values, deviations or faults remain");
  is.field("notes", &ImportResult::notes, "what differs from the model");
}

}  // namespace stepwire::simulink
