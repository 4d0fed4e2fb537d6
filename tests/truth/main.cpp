// SPDX-License-Identifier: MIT
// kdm_truth [--minutes M] [--kind KIND] [--seed SEED] [--count N] [--write FILE.obj]
// Random solids against their exact account, from a seed on (1); 2,000 of them unless minutes or a
// count are given. With a kind and a seed alone: that solid in words, and its input as a file; of
// an expression the operands, as FILE_0.obj and so on.
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>

#include "truth/judge.h"
#include "truth/tally.h"

namespace kdm::truth {
namespace {

using Options = std::map<std::string, std::string>;

Options parse(int count, char** words) {
  Options options;
  for (int i = 1; i < count; i += 2) {
    const std::string name = words[i];
    const std::vector<std::string> known = {"--minutes", "--kind", "--seed", "--count", "--write"};
    if (std::find(known.begin(), known.end(), name) == known.end() || i + 1 == count) {
      throw std::invalid_argument("'" + name + "': unknown, or without a value");
    }
    options[name.substr(2)] = words[i + 1];
  }
  return options;
}

std::string value_of(const Options& options, const char* name, const char* otherwise) {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second;
}

// With digits enough for the same 64 bits.
void write_obj(const std::string& path, const Mesh& mesh) {
  std::ofstream file(path);
  file << std::setprecision(17);
  for (const Vec3& p : mesh.positions) {
    file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write '" + path + "'");
}

// In words that JavaScript takes.
std::string text_of(const Expression& expression) {
  constexpr std::array<const char*, 5> kNames = {"", "union", "intersection", "symmetricDifference",
                                                 "complement"};
  std::vector<std::string> texts;
  for (const auto& [kind, first, second] : expression.nodes()) {
    if (kind == Expression::Kind::kOperand) {
      texts.push_back(std::to_string(first));
      continue;
    }
    const std::string name = kNames[static_cast<std::size_t>(kind)];
    const std::string rest = second == kNone ? "" : ", " + texts[second];
    texts.push_back("['" + name + "', " + texts[first] + rest + "]");
  }
  return texts.back();
}

// Writes the input; of an expression each operand, with its number before the name's ending.
void write_input(const std::string& path, const Solid& solid) {
  if (!solid.expression) return write_obj(path, solid.input);
  const std::size_t dot = std::min(path.rfind('.'), path.size());
  for (std::size_t i = 0; i < solid.operands.size(); ++i) {
    write_obj(path.substr(0, dot) + '_' + std::to_string(i) + path.substr(dot), solid.operands[i]);
  }
}

std::ostream& operator<<(std::ostream& out, const AllowedTopology& allowed) {
  for (const auto& [parts, euler] : allowed.any_of) out << " (" << parts << ", " << euler << ")";
  if (!allowed.ranges) return out;
  const auto& [least, most] = std::pair(allowed.least, allowed.most);
  return out << " from (" << least.first << ", " << least.second << ") to (" << most.first << ", "
             << most.second << ")";
}

int show_one(const std::string& kind, std::uint32_t seed, const std::string& path) {
  const Solid solid = make_solid(kind, seed);
  const Account& account = solid.account;
  std::cout << kind << " " << seed << ": " << solid.variant << ", " << solid.pose << ", "
            << solid.input.triangles.size() << " triangles, --tolerance " << std::setprecision(17)
            << solid.tolerance << std::setprecision(6) << "\naccount: volume " << account.volume
            << ", area " << area_of(account.boundary) << ", contacts " << account.contacts
            << ", parts and characteristic" << account.topology << '\n';
  if (solid.expression) std::cout << "expression: " << text_of(*solid.expression) << '\n';
  if (!path.empty()) write_input(path, solid);
  const Verdict verdict = judge(solid);
  std::cout << verdict.words << (verdict.right() ? "right\n" : "not right\n");
  return verdict.right() ? 0 : 1;
}

int run(const Options& options) {
  const std::string kind = value_of(options, "kind", "");
  const std::string path = value_of(options, "write", "");
  const auto seed = static_cast<std::uint32_t>(std::stoul(value_of(options, "seed", "1")));
  const double minutes = std::stod(value_of(options, "minutes", "0"));
  const std::size_t without = minutes > 0 ? std::numeric_limits<std::size_t>::max() : 2000;
  const bool counted = options.contains("count");
  const std::size_t most = counted ? std::stoul(value_of(options, "count", "")) : without;
  if (!kind.empty() && options.contains("seed") && !counted && minutes == 0) {
    return show_one(kind, seed, path);
  }
  if (!path.empty()) throw std::invalid_argument("--write goes with --kind and --seed alone");

  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::vector<std::string> wanted = kind.empty() ? kinds() : std::vector{kind};
  Tally tally;
  for (std::size_t n = 0; n < most; ++n) {
    const std::chrono::duration<double> spent = Clock::now() - start;
    if (minutes > 0 && spent.count() > 60 * minutes) break;
    const std::string& one = wanted[n % wanted.size()];
    const auto its = seed + static_cast<std::uint32_t>(n / wanted.size());
    const Solid solid = make_solid(one, its);
    tally.add(one, its, solid, judge(solid));
  }
  tally.write_table(std::cout);
  tally.write_failures(std::cout);
  return tally.all_right() ? 0 : 1;
}

}  // namespace
}  // namespace kdm::truth

int main(int count, char** words) {
  try {
    return kdm::truth::run(kdm::truth::parse(count, words));
  } catch (const std::exception& error) {
    std::cerr << "truth: " << error.what() << '\n';
    return 2;
  }
}
