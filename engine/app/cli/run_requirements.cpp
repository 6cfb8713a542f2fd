#include "engine/app/cli/run_requirements.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/io/file.hpp"

namespace stepwire::cli {

namespace {

void require_section(const RunCall& call, const session::LoadedModel& model) {
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "", message, {}});
  };
  if (call.requires_section == "fit" && !model.fit)
    refuse("has no section 'fit'; it names parameters and records");
  if (call.requires_section == "tune" && !model.tune)
    refuse("has no section 'tune'; it names parameters and what is minimised");
  if (call.requires_section == "study" && !model.study)
    refuse("has no section 'study'; it names task, people and conditions");
}

/// Refuses --csv unless the model has exactly one recorded table.
void require_one_table(const RunCall& call, const session::LoadedModel& model) {
  if (call.csv.empty()) return;
  const auto refuse = [&](const std::string& message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "", message, {}});
  };
  const std::size_t count = model.job.plan.diagram.records.size();
  if (count == 0) refuse("records nothing, and --csv is a table of what is recorded");
  if (model.study)
    refuse("has a section 'study', whose trials are no single table; --out has files for them");
  if (count != 1)
    refuse(fmt::format(
        "records at {} periods, which --csv, a single table, has no place for; --out has a file for each",
        count));
}

/// Refuses --part and --mpi for a model that cannot be shared, or without a folder for the journal. A share
/// is always a part of a sweep.
void require_shares(const RunCall& call, const session::LoadedModel& model) {
  if (!call.part && !call.mpi) return;
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, call.part ? "--part" : "--mpi", message, {}});
  };
  const bool sweeps = !model.job.points.empty();
  if (call.part && (!sweeps || model.study))
    refuse("needs a file with a section 'sweep', and without a study");
  if (!sweeps && !model.study && !model.fit && call.requires_section.empty())
    refuse("needs a file with a section 'sweep', 'study' or 'fit', whose runs processes can share");
  if (call.out.empty() || call.archive) refuse("needs --out DIR, in which what is done is kept");
}

/// Refuses a missing folder before the run rather than after it.
void require_place(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty()) io::require_folder(folder.string());
}

}  // namespace

void require_fitting(const RunCall& call, const session::LoadedModel& model) {
  require_section(call, model);
  require_one_table(call, model);
  require_shares(call, model);
  require_place(call.csv);
}

}  // namespace stepwire::cli
