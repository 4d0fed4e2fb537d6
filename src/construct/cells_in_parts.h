// SPDX-License-Identifier: MIT
// Threads share the recursion over cells: what lies within a cell does not depend on other cells.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "construct/cell_maker.h"

namespace kdm {

/// Tells whether the cells of a task may be made by several threads: there are several, the rule is
/// local, nothing is noted or taken over, and there are so many triangles that it pays.
bool may_be_shared(const CellTask& task);

/// Makes a rule that says the same as that of the task, and asks the given model.
using MakeRule = std::function<std::unique_ptr<SplitRule>(InsideModel& model)>;

/// Makes the upper cells on this thread and shares what is within them among several. The cells are
/// those that `CellMaker::make_all` makes, in the same order, and the rule and the model of the
/// task know afterwards what they would know then. Returns nothing, and leaves the model as it was,
/// if the model cannot be asked by several threads, or if a budget may have been exceeded: which
/// cells that leaves out depends on the order in which cells are made.
std::optional<MadeCells> make_cells_in_parts(const CellTask& task, const Budget& budget,
                                             const MakeRule& make_rule);

}  // namespace kdm
