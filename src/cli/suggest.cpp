// SPDX-License-Identifier: MIT
// Compares words by the changes that lead from one to the other.
#include "cli/suggest.h"

#include <algorithm>

namespace kdm::cli {
namespace {

// How many letters are put in, left out or replaced, or change places with their neighbours.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string nearest(std::string_view typed, const std::vector<std::string>& words) {
  constexpr std::size_t kLongest = 64;  // no word that is meant is longer
  if (typed.empty() || typed.size() > kLongest) return "";
  std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
  std::string best;
  for (const std::string& word : words) {
    const std::size_t changes = distance(typed, word);
    if (changes < least) {
      least = changes;
      best = word;
    }
  }
  if (!best.empty() || typed.size() < 3) return best;
  for (const std::string& word : words) {
    if (word.rfind(typed, 0) == 0) return word;
  }
  for (const std::string& word : words) {
    if (word.find(typed) != std::string::npos) return word;
  }
  return "";
}

std::string did_you_mean(std::string_view typed, const std::vector<std::string>& words) {
  const std::string near = nearest(typed, words);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

}  // namespace kdm::cli
