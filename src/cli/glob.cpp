// SPDX-License-Identifier: MIT
// Matches names against patterns, and walks folders. cli-glob.ts does the same.
#include "cli/glob.h"

#include <algorithm>
#include <filesystem>

namespace kdm::cli {
namespace {

namespace fs = std::filesystem;

// The characters of UTF-8 text. Bytes that are none count one by one.
std::u32string characters(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(at++);
    std::size_t more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
    char32_t value = lead;
    if (more > 0 && at + more <= text.size()) {
      value = lead & (0x3fu >> more);
      for (; more > 0; --more) value = value << 6 | (byte(at++) & 0x3fu);
    }
    result += value;
  }
  return result;
}

// One place of a pattern that stands for one character.
struct Place {
  bool fits = false;
  std::size_t end = 0;  // where the pattern goes on
};

// The class that begins behind the bracket at `open`. Without a closing bracket the bracket is
// itself.
Place match_class(const std::u32string& pattern, std::size_t open, char32_t c) {
  std::size_t at = open + 1;
  const bool negated = at < pattern.size() && (pattern[at] == U'!' || pattern[at] == U'^');
  if (negated) ++at;
  const std::size_t close = pattern.find(U']', at + 1);
  if (close == std::u32string::npos) return {c == U'[', open + 1};
  bool found = false;
  for (; at < close; ++at) {
    const char32_t low = pattern[at];
    const bool range = at + 2 < close && pattern[at + 1] == U'-';
    if (range) at += 2;
    found = found || (low <= c && c <= pattern[at]);
  }
  return {found != negated, close + 1};
}

Place match_one(const std::u32string& pattern, std::size_t at, char32_t c) {
  if (pattern[at] == U'?') return {true, at + 1};
  if (pattern[at] == U'[') return match_class(pattern, at, c);
  return {pattern[at] == c, at + 1};
}

std::vector<std::string> parts_of(const std::string& pattern) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t slash = pattern.find('/', begin);
    parts.push_back(pattern.substr(begin, slash - begin));
    if (slash == std::string::npos) return parts;
    begin = slash + 1;
  }
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  return names;
}

// `before` is the path so far, with its slash.
void walk(const std::string& before, const std::vector<std::string>& parts, std::size_t part,
          std::vector<std::string>& found) {
  std::error_code error;
  const std::string& pattern = parts[part];
  const bool last = part + 1 == parts.size();
  if (!is_pattern(pattern)) {
    if (!last) return walk(before + pattern + '/', parts, part + 1, found);
    if (fs::is_regular_file(before + pattern, error)) found.push_back(before + pattern);
    return;
  }
  const bool deep = pattern == "**" && !last;
  if (deep) walk(before, parts, part + 1, found);
  for (const std::string& name : names_in(before)) {
    if (!fits(name, pattern)) continue;
    const std::string path = before + name;
    const bool folder = fs::is_directory(path, error);
    if (last) {
      if (fs::is_regular_file(path, error)) found.push_back(path);
    } else if (deep) {  // not through links, which may lead back
      if (folder && !fs::is_symlink(path, error)) walk(path + '/', parts, part, found);
    } else if (folder) {
      walk(path + '/', parts, part + 1, found);
    }
  }
}

}  // namespace

bool is_pattern(std::string_view text) { return text.find_first_of("*?[") != text.npos; }

bool fits(std::string_view name, std::string_view pattern) {
  if (!name.empty() && name[0] == '.' && (pattern.empty() || pattern[0] != '.')) return false;
  const std::u32string text = characters(name);
  const std::u32string wanted = characters(pattern);
  constexpr std::size_t kNowhere = std::u32string::npos;
  std::size_t at = 0;           // in the pattern
  std::size_t star = kNowhere;  // behind the last star, to which one can go back
  std::size_t resume = 0;       // where in the text that star ends
  for (std::size_t i = 0; i < text.size();) {
    if (at < wanted.size() && wanted[at] == U'*') {
      star = ++at;
      resume = i;
      continue;
    }
    const Place place = at < wanted.size() ? match_one(wanted, at, text[i]) : Place{};
    if (place.fits) {
      at = place.end;
      ++i;
    } else if (star != kNowhere) {
      at = star;
      i = ++resume;
    } else {
      return false;
    }
  }
  while (at < wanted.size() && wanted[at] == U'*') ++at;
  return at == wanted.size();
}

std::vector<std::string> expand(const std::string& pattern) {
  std::vector<std::string> found;
  walk("", parts_of(pattern), 0, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace kdm::cli
