// SPDX-License-Identifier: MIT
#include "construct/cells_in_parts.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "threads/share_work.h"

namespace kdm {
namespace {

// So many triangles are worth another thread.
constexpr std::size_t kTrianglesPerThread = 1000;
// Parts per thread: enough that all threads end at about the same time.
constexpr std::size_t kPartsPerWorker = 12;

// What one thread asks. The thread makes its rule itself, since that takes time for each triangle.
struct Oracle {
  std::unique_ptr<InsideModel> model;
  std::size_t work_before;  // of the model, when it was made
  std::unique_ptr<SplitRule> rule{};

  std::size_t work() const { return model->work() - work_before; }
};

// Returns how many threads are worth it.
int threads_for(std::size_t triangles) {
  return static_cast<int>(
      std::min(static_cast<std::size_t>(workers()), triangles / kTrianglesPerThread));
}

// Reports the progress of all threads; the first of them, which is the caller's, does so.
class SharedProgress {
 public:
  SharedProgress(const Progress& progress, double done) : progress_(progress), done_(done) {}

  // Returns the progress function for a part on the thread with this number.
  Progress of_part(const CellFrame& part, int worker) {
    if (worker != 0) return [this](double, std::string_view) { return !stopped_; };
    if (!progress_) return {};
    return [this, &part](double fraction, std::string_view phase) {
      return go_on(done() + fraction - part.done_before, phase);
    };
  }

  void end_part(const CellFrame& part, int worker) {
    add(part.done_after - part.done_before);
    if (worker == 0 && progress_) {
      report_progress([this](double f, std::string_view phase) { return go_on(f, phase); }, done(),
                      "build");
    }
  }

 private:
  bool go_on(double fraction, std::string_view phase) {
    const bool answer = progress_(fraction, phase);
    if (!answer) stopped_ = true;
    return answer;
  }

  void add(double done) {
    const std::lock_guard lock(mutex_);
    done_ += done;
  }

  double done() {
    const std::lock_guard lock(mutex_);
    return done_;
  }

  const Progress& progress_;
  std::mutex mutex_;
  double done_;
  std::atomic<bool> stopped_ = false;
};

// Puts the parts in the places where they were left out.
class Assembly {
 public:
  Assembly(MadeCells& top, const std::vector<Subtree>& subtrees, std::vector<MadeCells>& parts)
      : top_(top), subtrees_(subtrees), parts_(parts) {
    SplitId splits = top.splits();
    for (const MadeCells& part : parts) splits += part.splits();
    whole_.cells.resize(2 * std::size_t{splits} + 1);
    whole_.crossings.edge_begin.reserve(4 * std::size_t{splits} + 1);
    number_splits();
  }

  MadeCells run() {
    for (CellId c = 0; c < top_.cells.size(); ++c) {
      const Cell& cell = top_.cells[c];
      if (!cell.leaf()) {
        whole_.cells[number_of(c)] =
            Cell(2 * top_number_[cell.split()] + 1, cell.axis(), cell.value());
      }
    }
    SplitId of_top = 0;
    Index unresolved = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      append_top(of_top, subtrees_[i].splits_before, unresolved, subtrees_[i].unresolved_before);
      append_part(i);
    }
    append_top(of_top, top_.splits(), unresolved, static_cast<Index>(top_.unresolved.size()));
    return std::move(whole_);
  }

 private:
  // Splits are numbered in the order in which one thread would have made them.
  void number_splits() {
    SplitId number = 0;
    for (std::size_t i = 0; i <= parts_.size(); ++i) {
      const SplitId end = i < parts_.size() ? subtrees_[i].splits_before : top_.splits();
      while (top_number_.size() < end) top_number_.push_back(number++);
      if (i == parts_.size()) break;
      part_number_.push_back(number);
      number += parts_[i].splits();
    }
  }

  // Returns the number that a cell of the top has in the whole.
  CellId number_of(CellId cell) const {
    return cell == 0 ? 0 : 2 * top_number_[(cell - 1) / 2] + 1 + (cell - 1) % 2;
  }

  void append_top(SplitId& split, SplitId end, Index& unresolved, Index unresolved_end) {
    whole_.crossings.append(top_.crossings, 4 * split, 4 * end);
    split = end;
    whole_.unresolved.insert(whole_.unresolved.end(), top_.unresolved.begin() + unresolved,
                             top_.unresolved.begin() + unresolved_end);
    unresolved = unresolved_end;
  }

  void append_part(std::size_t i) {
    MadeCells& part = parts_[i];
    const SplitId first = part_number_[i];
    for (CellId c = 0; c < part.cells.size(); ++c) {
      const Cell& cell = part.cells[c];
      if (cell.leaf()) continue;
      const CellId number = c == 0 ? number_of(subtrees_[i].frame.cell) : c + 2 * first;
      whole_.cells[number] = Cell(2 * (cell.split() + first) + 1, cell.axis(), cell.value());
    }
    whole_.crossings.append(part.crossings, 0, 4 * part.splits());
    whole_.unresolved.insert(whole_.unresolved.end(), part.unresolved.begin(),
                             part.unresolved.end());
    part = {};
  }

  const MadeCells& top_;
  const std::vector<Subtree>& subtrees_;
  std::vector<MadeCells>& parts_;
  std::vector<SplitId> top_number_;   // per split of the top: its number in the whole
  std::vector<SplitId> part_number_;  // per part: the number of its first split
  MadeCells whole_;
};

}  // namespace

bool may_be_shared(const CellTask& task) {
  return threads_for(task.surface.triangles.size()) > 1 && task.rule.is_local() &&
         task.memory.notes == nullptr && task.memory.former == nullptr;
}

std::optional<MadeCells> make_cells_in_parts(const CellTask& task, const Budget& budget,
                                             const MakeRule& make_rule) {
  const std::size_t triangles = task.surface.triangles.size();
  const int threads = threads_for(triangles);
  std::vector<Oracle> oracles;
  const auto add_oracle = [&](const InsideModel& model) {
    std::unique_ptr<InsideModel> fork = model.fork();
    if (fork) oracles.push_back({std::move(fork), model.work()});
  };
  const auto ask = [&](int worker, const Progress& progress) {
    Oracle& oracle = oracles[static_cast<std::size_t>(worker)];
    if (!oracle.rule) oracle.rule = make_rule(*oracle.model);
    return CellTask{task.surface, task.depth, *oracle.model, *oracle.rule, task.memory, progress};
  };
  add_oracle(task.model);
  if (oracles.empty()) return std::nullopt;
  CellMaker top(ask(0, task.progress), budget);
  const std::vector<Subtree> subtrees = top.make_top(
      static_cast<Index>(triangles / (kPartsPerWorker * static_cast<std::size_t>(threads))));
  // The others begin with the states that are known now: those that the parts begin with.
  for (int i = 1; i < threads; ++i) add_oracle(*oracles[0].model);
  double left = 0;
  for (const Subtree& subtree : subtrees)
    left += subtree.frame.done_after - subtree.frame.done_before;
  SharedProgress progress(task.progress, 1 - left);
  std::vector<MadeCells> parts(subtrees.size());
  std::atomic<bool> sufficed = top.budget().sufficed();
  share_work(subtrees.size(), static_cast<int>(oracles.size()), [&](std::size_t i, int worker) {
    if (!sufficed) return;
    const Subtree& subtree = subtrees[i];
    const Progress of_part = progress.of_part(subtree.frame, worker);
    CellMaker maker(ask(worker, of_part), budget, subtree);
    maker.make_all();
    if (!maker.budget().sufficed()) sufficed = false;
    parts[i] = std::move(maker.made());
    progress.end_part(subtree.frame, worker);
  });
  if (!sufficed) return std::nullopt;
  MadeCells whole = Assembly(top.made(), subtrees, parts).run();
  // One thread does no more than several do together.
  Budget of_all = budget;
  std::size_t fine_splits = 0;
  std::size_t work = task.model.work();
  for (const Oracle& oracle : oracles) {
    if (oracle.rule) fine_splits += oracle.rule->tally().fine_splits;
    work += oracle.work();
  }
  if (!of_all.take_splits(whole.splits()) || of_all.exceeded(work, 1) ||
      !task.rule.has_budget(fine_splits)) {
    return std::nullopt;
  }
  task.rule.count_cells(fine_splits, whole.unresolved);
  for (const Oracle& oracle : oracles) task.model.join(*oracle.model);
  return whole;
}

}  // namespace kdm
