// Simulates the utilisation of up to 10,000 processes of mpirun by a sweep, by their messages. The costs are
// measured by `mpirun -np 3 build/bench/cluster_schedule --measure`, with the program's own server, processes
// and journal.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "bench/schedule.hpp"
#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/item_server.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/relay.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace {

using namespace stepwire;

// Measured on a 2-core AMD EPYC under other load; the latency is the interval at which a process polls.
constexpr schedule::Costs measured{.answer = 12e-6, .item = 0.2e-6, .latency = 1e-3};
constexpr std::size_t row = 130;  // bytes of a run with one row of two numbers

/// Answers each item at once with the bytes of one row.
void answer_all(messages::Connection& server) {
  cluster::ItemClient client(server);
  const std::string bytes(row, '\0');
  while (client.next_job())
    while (const auto item = client.next())
      client.put(item->number, cluster::KeptItems::record_of(item->number, bytes));
}

void measure_round(cluster::ItemServer& server, const std::string& folder, int round) {
  constexpr std::size_t count = 200'000;
  cluster::KeptItems kept(fmt::format("{}/{}.journal", folder, round), "bench", count);
  std::vector<messages::Item> items(count);
  for (std::size_t i = 0; i < count; ++i) items[i].number = i;
  kept.want(items);
  server.serve(kept, "bench", {});
}

int measure() {
  messages::WorkerProcess worker;
  if (worker.is_worker()) return answer_all(worker.other()), 0;
  const auto messages = messages::open_mpi();
  if (messages->rank() > 0) {
    cluster::relay(*messages, worker);
  } else {
    worker.end();
    const subprocess::ScratchFolder folder;
    cluster::ItemServer server(*messages);
    for (int round = 0; round < 5; ++round) measure_round(server, folder.path(), round);
    server.finish();
    fmt::print("an answer takes {:.2f} us, to keep a run {:.2f} us\n", 1e6 * server.seconds_of_answer(),
               1e6 * server.seconds_of_item());
  }
  messages->finish();
  return 0;
}

/// `seconds` is the duration of the sweep at full utilisation; 0: it has a million runs.
void print_row(double run, double seconds, schedule::Rule rule, std::size_t parts,
               const schedule::Costs& costs) {
  const char* const name = rule == schedule::Rule::by_number ? "by number" : "by time";
  fmt::print("| {:g} ms | {}{} |", 1e3 * run, name, parts > 1 ? fmt::format(", {} shares", parts) : "");
  for (const std::size_t ranks : {10u, 100u, 1000u, 10'000u}) {
    const double runs = seconds > 0.0 ? seconds * static_cast<double>(ranks) / run : 1e6;
    const schedule::Outcome outcome =
        ranks < 4 * parts ? schedule::Outcome{} : simulate({ranks, parts, run, runs, rule}, costs);
    fmt::print(" {} |", ranks < 4 * parts
                            ? ""
                            : fmt::format("{:.2f} ({:.0f} %)", outcome.efficiency, 100.0 * outcome.busy));
  }
  fmt::print("\n");
}

void print_table(const char* title, double seconds, const schedule::Costs& costs) {
  fmt::print("| {} | given at once | 10 ranks | 100 | 1000 | 10000 |\n|---|---|---|---|---|---|\n", title);
  for (const double run : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    print_row(run, seconds, schedule::Rule::by_number, 1, costs);
    print_row(run, seconds, schedule::Rule::by_time, 1, costs);
    print_row(run, seconds, schedule::Rule::by_time, 20, costs);
  }
}

int simulate_all(const schedule::Costs& costs) {
  print_table("a run of a sweep of 100 s takes", 100.0, costs);
  fmt::print("\n");
  print_table("a run of a million takes", 0.0, costs);
  return 0;
}

/// Returns a cost of the command line in microseconds, "--answer 12".
double cost_of(std::span<char*> words, const char* name, double otherwise) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (std::strcmp(words[i], name) == 0) return 1e-6 * std::strtod(words[i + 1], nullptr);
  return otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span words(argv, static_cast<std::size_t>(argc));
  if (words.size() == 2 && std::strcmp(words[1], "--measure") == 0) return measure();
  return simulate_all({.answer = cost_of(words, "--answer", measured.answer),
                       .item = cost_of(words, "--item", measured.item),
                       .latency = cost_of(words, "--latency", measured.latency)});
}
