#include "engine/app/report/profile_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "engine/app/session/run_files.hpp"
#include "engine/base/text/count.hpp"
#include "engine/view/plot/bar_chart.hpp"
#include "engine/view/plot/plot_builder.hpp"

namespace stepwire::report {

using result::Record;

namespace {

constexpr std::size_t max_shown = 20;
constexpr const char* left_name = "what is left";

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double nanoseconds_per_call(const profile::Cost& cost) {
  return cost.calls == 0 ? 0.0 : 1e9 * cost.seconds / static_cast<double>(cost.calls);
}

double percent(const profile::Profile& profile, double seconds) {
  return 100.0 * profile.share(seconds);
}

/// Returns the costs outside of blocks: those of the run itself, and the unattributed remainder.
std::vector<profile::RunCost> rest_of(const profile::Profile& profile) {
  std::vector<profile::RunCost> rest = profile.others;
  rest.push_back({left_name, {0, profile.left()}});
  return rest;
}

/// Returns calls and share of a phase. A part gets only its share: it contains calls of many blocks, so a
/// mean time of one call has no meaning.
std::string phase_text(const profile::Profile& profile, const profile::BlockCost& block,
                       const profile::Cost& cost) {
  if (cost.calls == 0) return fmt::format("{:>16}", "-");
  const std::string each = block.part ? "" : fmt::format("{:.3g}", nanoseconds_per_call(cost));
  return fmt::format("{:>9}{:>7.1f}", each, percent(profile, cost.seconds));
}

std::string block_text(const profile::Profile& profile, const profile::BlockCost& block, std::size_t width) {
  const profile::Cost total = block.total();
  std::string text =
      fmt::format("    {:<{}} {:<18}{:>11}{:>7.1f}{:>7.1f}", block.name, width, block.type, total.calls,
                  percent(profile, total.seconds), percent(profile, block.self()));
  for (const profile::Cost& cost : block.phases) text += phase_text(profile, block, cost);
  return text + "\n";
}

std::string head_text(std::size_t width) {
  std::string names = fmt::format("    {:<{}} {:<18}{:>11}{:>7}{:>7}", "", width, "", "", "total", "self");
  std::string units =
      fmt::format("    {:<{}} {:<18}{:>11}{:>7}{:>7}", "block", width, "type", "calls", "%", "%");
  for (const char* phase : profile::phase_names) {
    names += fmt::format("{:>16}", phase);
    units += fmt::format("{:>9}{:>7}", "ns", "%");
  }
  return names + "\n" + units + "\n";
}

std::string loop_cost_text(const run::LoopCost& loop) {
  return fmt::format(
      "    algebraic loop {}: {}, {} at {}, {:.3g} on the mean, {} at most\n", loop.path,
      text::counted(loop.unknowns, "unknown"), text::counted(loop.iterations, "iteration"),
      text::counted(loop.instants, "instant"),
      static_cast<double>(loop.iterations) / static_cast<double>(std::max<std::int64_t>(1, loop.instants)),
      loop.most);
}

std::string csv_row(const profile::Profile& profile, const std::string& name, const std::string& type,
                    std::int64_t calls, double self, double total) {
  return fmt::format("{},{},{},{:.6g},{:.6g},{:.4g},{:.4g}", name, type, calls, self, total,
                     percent(profile, self), percent(profile, total));
}

plot::Bar bar_of(const profile::Profile& profile, const profile::BlockCost& block) {
  plot::Bar bar{fmt::format("{} ({})", block.name, block.type), {}};
  for (const profile::Cost& cost : block.phases) bar.pieces.push_back(percent(profile, cost.seconds));
  bar.pieces.push_back(0.0);
  return bar;
}

}  // namespace

profile::Profile profile_of(const session::LoadedModel& model, const std::atomic<bool>* interrupt) {
  return profile::profile_plan(model.job.plan, {steady_seconds, interrupt});
}

std::string profile_text(const session::LoadedModel& model, const profile::Profile& profile) {
  const std::size_t shown = std::min(profile.blocks.size(), max_shown);
  std::size_t width = 14;
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, profile.blocks[i].name.size());
  const double per_tick =
      profile.seconds * 1e9 / static_cast<double>(std::max<std::int64_t>(1, profile.ticks));
  std::string text =
      fmt::format("  profile{}: {} ticks in {:.3g} s, {:.3g} ns each; ns are of one call, % of the run\n",
                  model.job.points.empty() ? "" : " of the file's own values, not of its sweep",
                  profile.ticks, profile.seconds, per_tick);
  text += head_text(width);
  for (std::size_t i = 0; i < shown; ++i) text += block_text(profile, profile.blocks[i], width);
  if (shown < profile.blocks.size())
    text +=
        fmt::format("    and {} more (--out DIR writes all to profile.csv)\n", profile.blocks.size() - shown);
  for (const profile::RunCost& other : rest_of(profile))
    text += fmt::format("    {:<{}} {:<18}{:>11}{:>7.1f}{:>7.1f}\n", other.name, width, "run",
                        other.cost.calls > 0 ? std::to_string(other.cost.calls) : "-",
                        percent(profile, other.cost.seconds), percent(profile, other.cost.seconds));
  for (const run::LoopCost& loop : profile.loops) text += loop_cost_text(loop);
  return text;
}

std::string profile_csv(const profile::Profile& profile) {
  std::string text = "name,type,calls,self [s],total [s],self [%],total [%]";
  for (const char* phase : profile::phase_names)
    text += fmt::format(",{0} calls,{0} [ns per call],{0} [%]", phase);
  text += "\n";
  for (const profile::BlockCost& block : profile.blocks) {
    const profile::Cost total = block.total();
    text += csv_row(profile, block.name, block.type, total.calls, block.self(), total.seconds);
    for (const profile::Cost& cost : block.phases)
      text += fmt::format(",{},{:.4g},{:.4g}", cost.calls, nanoseconds_per_call(cost),
                          percent(profile, cost.seconds));
    text += "\n";
  }
  for (const profile::RunCost& other : rest_of(profile))
    text += csv_row(profile, other.name, "run", other.cost.calls, other.cost.seconds, other.cost.seconds) +
            std::string(3 * profile::phase_count, ',') + "\n";
  return text;
}

/// Cost of the calls of a phase.
struct PhaseCost : profile::Cost {};

/// Cost of a block.
struct CostOfBlock : profile::BlockCost {};

/// Cost of the run itself.
struct OtherCost : profile::RunCost {};

static void declare(Record<PhaseCost>& is) {
  is.named("PhaseCost", "Calls of a block in a phase of the run.");
  is.field("calls", &PhaseCost::calls, "number of calls");
  is.field("seconds", &PhaseCost::seconds, "their time", "s");
}

static void declare(Record<CostOfBlock>& is) {
  is.named("BlockCost", "Cost of a block, or of all blocks in a part.");
  is.field("name", &CostOfBlock::name, "name of the block or the part");
  is.field("type", &CostOfBlock::type, "type of the block, or part");
  is.field("calls", result::path(&CostOfBlock::total, &profile::Cost::calls), "number of calls");
  is.field("self", &CostOfBlock::self, "time of the block itself; 0 for a part", "s");
  is.field("total", result::path(&CostOfBlock::total, &profile::Cost::seconds), "time of all calls", "s");
  is.field(
      "phases",
      [](const CostOfBlock& of) {
        result::Map<PhaseCost> phases;
        for (std::size_t phase = 0; phase < profile::phase_count; ++phase)
          phases.push_back({profile::phase_names[phase], {of.phases[phase]}});
        return phases;
      },
      "calls in the phases timed, outputs, stages, derivatives and updates");
}

static void declare(Record<OtherCost>& is) {
  is.named("OtherCost", "Cost of the run outside of blocks.");
  is.field("name", &OtherCost::name, "work of the run");
  is.field("calls", result::path(&OtherCost::cost, &profile::Cost::calls), "number of calls");
  is.field("seconds", result::path(&OtherCost::cost, &profile::Cost::seconds), "their time", "s");
}

void declare(Record<ProfileReport>& is) {
  is.named("Profile", "Distribution of the time of a run: run --profile.");
  is.field("ticks", &ProfileReport::ticks, "ticks of the run");
  is.field("seconds", &ProfileReport::seconds, "time of all steps", "s");
  is.field(
      "blocks", [](const ProfileReport& of) { return result::as<CostOfBlock>(of.blocks); },
      "blocks and parts, the most expensive first");
  is.field(
      "others", [](const ProfileReport& of) { return result::as<OtherCost>(of.others); },
      "costs outside of blocks");
  is.field(
      "algebraic_loops", [](const ProfileReport& of) { return result::as<session::AlgebraicLoop>(of.loops); },
      "costs of algebraic loops, whose repeated calls are not counted above");
  is.field("left", &ProfileReport::left, "time in none of the other numbers", "s");
}

plot::FigureSpec profile_figure(const session::LoadedModel& model, const profile::Profile& profile) {
  const std::string& title = model.job.plan.diagram.title;
  plot::BarChart chart{title.empty() ? model.file : title, "share of the run [%]", {}, {}};
  for (std::size_t phase = 0; phase < profile::phase_count; ++phase)
    chart.kinds.push_back({profile::phase_names[phase], plot::curve_color(phase)});
  chart.kinds.push_back({"the run", "#9a9a9a"});
  for (const profile::BlockCost& block : profile.blocks)
    if (!block.part && block.self() > 0.0 && chart.bars.size() < max_shown)
      chart.bars.push_back(bar_of(profile, block));
  for (const profile::RunCost& other : rest_of(profile)) {
    plot::Bar bar{other.name, std::vector<double>(profile::phase_count, 0.0), true};
    bar.pieces.push_back(std::max(0.0, percent(profile, other.cost.seconds)));
    chart.bars.push_back(std::move(bar));
  }
  return plot::figure_of(chart);
}

}  // namespace stepwire::report
