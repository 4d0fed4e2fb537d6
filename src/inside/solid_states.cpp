// SPDX-License-Identifier: MIT
#include "inside/solid_states.h"

#include <algorithm>
#include <utility>

#include "inside/winding.h"

namespace kdm {

SolidStates::SolidStates(SolidFunction function, std::vector<InsideRule> rules)
    : function_(std::move(function)), rules_(std::move(rules)), in_solids_(rules_.size()) {
  add(std::vector<int>(solids(), 0));
  in_order_.push_back(0);
}

void SolidStates::mark_solids(const int* windings) {
  for (std::size_t i = 0; i < solids(); ++i) {
    in_solids_.set(i, kdm::is_inside(rules_[i], windings[i]));
  }
}

void SolidStates::add(const std::vector<int>& windings) {
  windings_.insert(windings_.end(), windings.begin(), windings.end());
  next_.resize(2 * windings_.size(), -1);
  mark_solids(windings.data());
  inside_.push_back(function_.value(in_solids_));
}

int SolidStates::find(int state, Index solid, bool leaving) {
  const auto begin = [&](int s) { return windings_.begin() + s * static_cast<int>(solids()); };
  std::vector<int> wanted(begin(state), begin(state + 1));
  wanted[solid] += leaving ? -1 : 1;
  const auto place = std::lower_bound(
      in_order_.begin(), in_order_.end(), wanted, [&](int s, const std::vector<int>& w) {
        return std::lexicographical_compare(begin(s), begin(s + 1), w.begin(), w.end());
      });
  int found = static_cast<int>(inside_.size());
  if (place != in_order_.end() && std::equal(wanted.begin(), wanted.end(), begin(*place))) {
    found = *place;
  } else {
    in_order_.insert(place, found);
    add(wanted);
  }
  const auto way = [&](int from, bool back) {
    return (static_cast<std::size_t>(from) * solids() + solid) * 2 + (leaving != back);
  };
  next_[way(state, false)] = found;
  next_[way(found, true)] = state;
  return found;
}

void SolidStates::keep_relevant(int state, Marks& solids_left) {
  mark_solids(windings_.data() + static_cast<std::size_t>(state) * solids());
  function_.keep_relevant(in_solids_, solids_left);
}

}  // namespace kdm
