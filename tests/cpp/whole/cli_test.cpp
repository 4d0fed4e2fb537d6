// SPDX-License-Identifier: MIT
// Runs the native command line as a user does: arguments, exit status, output, report, files.
#ifdef KDM_CLI_PATH

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "kdmanifold/mesh_io.h"
#include "kdmanifold/version.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Outcome {
  int status = -1;
  std::string out, err;
};

class Cli : public ::testing::Test {
 protected:
  Cli() {
    const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("kdmanifold-cli-" + std::string(info->name()) + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    write("cube.obj", shapes::cube());
  }
  ~Cli() override { fs::remove_all(folder_); }

  // In the test's folder, so that file names are short. Arguments are those of a shell.
  Outcome run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && '" + KDM_CLI_PATH + "' " +
                                arguments + " > stdout.txt 2> stderr.txt";
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout.txt"),
                    read("stderr.txt")};
    fs::remove(folder_ / "stdout.txt");
    fs::remove(folder_ / "stderr.txt");
    return outcome;
  }

  // Whatever is wrong: status 2, nothing on standard output, one line, and no file more.
  std::string complaint(const std::string& arguments) const {
    const std::set<std::string> before = files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("kdmanifold: ", 0), 0u) << outcome.err;
    EXPECT_EQ(files(), before) << arguments;
    return outcome.err.size() < 13 ? "" : outcome.err.substr(12, outcome.err.size() - 13);
  }

  Json report(const std::string& arguments, int status = 0) const {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }

  std::string read(const char* name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  void write(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  void write(const char* name, const Mesh& mesh) const {
    write_mesh((folder_ / name).string(), mesh);
  }
  Mesh mesh(const char* name) const { return read_mesh((folder_ / name).string()); }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  fs::path folder_;
};

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

using Names = std::vector<std::string>;

// Quick, and with as many cells whatever becomes of the other rules.
const std::string kCoarse = " --strategy uniform --depth 9";

TEST_F(Cli, HelpListsTheOptions) {
  for (const char* flag : {"--help", "-h", "--help nonsense.obj"}) {
    const Outcome outcome = run(flag);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    std::set<std::string> options;
    const std::regex option("--[a-z][a-z-]*");
    for (std::sregex_iterator it(outcome.out.begin(), outcome.out.end(), option), end; it != end;
         ++it) {
      options.insert(it->str());
    }
    EXPECT_EQ(options, (std::set<std::string>{"--add-material",
                                              "--box",
                                              "--cells",
                                              "--check",
                                              "--crease-angle",
                                              "--depth",
                                              "--difference",
                                              "--drop-cavities",
                                              "--drop-handles",
                                              "--drop-parts",
                                              "--force",
                                              "--format",
                                              "--help",
                                              "--input-format",
                                              "--inside",
                                              "--intersection",
                                              "--json",
                                              "--largest-hole",
                                              "--link-error",
                                              "--minimum-gap",
                                              "--minimum-thickness",
                                              "--no-reduce",
                                              "--no-strict",
                                              "--no-unfold",
                                              "--normals",
                                              "--out-dir",
                                              "--output",
                                              "--pairing",
                                              "--parts",
                                              "--position",
                                              "--quads",
                                              "--quiet",
                                              "--relative-tolerance",
                                              "--remove-material",
                                              "--save-grid",
                                              "--simplify",
                                              "--split-error",
                                              "--stats",
                                              "--strategy",
                                              "--strict",
                                              "--symmetric-difference",
                                              "--target-triangles",
                                              "--thicken",
                                              "--thicken-what",
                                              "--threads",
                                              "--tolerance",
                                              "--transform",
                                              "--union",
                                              "--version",
                                              "--winding-threshold"}));
    EXPECT_NE(outcome.out.find("adaptive|octree|feature|median|uniform"), std::string::npos);
  }
}

TEST_F(Cli, Version) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "kdmanifold " KDM_VERSION "\n");
}

TEST_F(Cli, ConvertsBetweenAllFormats) {
  for (const char* from : {"obj", "stl", "ply", "off"}) {
    const std::string input = std::string("in.") + from;
    write(input.c_str(), shapes::cube());
    for (const char* to : {"obj", "stl", "ply", "off"}) {
      const std::string output = std::string("out-") + from + "." + to;
      const Outcome outcome = run(input + " -o " + output + kCoarse);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
      EXPECT_NE(outcome.out.find("closed 2-manifold"), std::string::npos) << outcome.out;
      EXPECT_NE(outcome.out.find(output), std::string::npos) << outcome.out;
      const Mesh result = mesh(output.c_str());
      EXPECT_GT(result.triangles.size(), 12u);
      if (std::string(to) != "stl") {
        EXPECT_TRUE(check::is_two_manifold(result));
      }
      EXPECT_NEAR(describe(result).volume, 1, 1e-4);
    }
  }
}

TEST_F(Cli, SameInputSameBytes) {
  write("torus.ply", shapes::torus());
  for (const char* output : {"a.obj", "b.obj"}) {
    EXPECT_EQ(run(std::string("torus.ply -o ") + output).status, 0);
  }
  EXPECT_FALSE(read("a.obj").empty());
  EXPECT_EQ(read("a.obj"), read("b.obj"));
}

TEST_F(Cli, ReportHasTheDocumentedKeys) {
  const Json json = report("cube.obj -o out.ply --check" + kCoarse);
  EXPECT_EQ(keys(json), (Names{"input", "grid", "output", "lost", "error", "warnings", "check",
                               "seconds", "peakBytes"}));
  EXPECT_EQ(keys(json["lost"]), (Names{"area", "parts", "largest", "share", "innerArea", "faces"}));
  EXPECT_EQ(keys(json["error"]), (Names{"toInput", "toOutput"}));
  for (const char* direction : {"toInput", "toOutput"}) {
    EXPECT_EQ(keys(json["error"][direction]), (Names{"largest", "rms"}));
    EXPECT_LT(json["error"][direction]["largest"], 1e-5);
  }
  EXPECT_EQ(json["lost"]["area"], 0);
  EXPECT_EQ(json["lost"]["faces"], 0);
  EXPECT_EQ(keys(json["input"]), (Names{"vertices",        "triangles",
                                        "closed",          "boundaryEdges",
                                        "boundaryLoops",   "nonManifoldEdges",
                                        "degenerateFaces", "cancelledFaces",
                                        "duplicateFaces",  "sewnEdges",
                                        "turnedFaces",     "turnedParts",
                                        "nestingKnown",    "components",
                                        "patchedHoles",    "patchArea",
                                        "lostParts",       "lostArea",
                                        "largestLost",     "thickenedParts",
                                        "rebuiltParts",    "rebuildingTolerance",
                                        "sewingDistance",  "strayParts",
                                        "extent",          "flipped",
                                        "latticeStep"}));
  EXPECT_EQ(keys(json["grid"]), (Names{"cells",
                                       "leaves",
                                       "hits",
                                       "depth",
                                       "sheet",
                                       "bytes",
                                       "askedTolerance",
                                       "tolerance",
                                       "simplified",
                                       "windingThreshold",
                                       "topologyResolved",
                                       "unresolvedLeaves",
                                       "unresolvedPositions",
                                       "exactParts",
                                       "exactTriangles",
                                       "thinParts",
                                       "ambiguousFaces",
                                       "guessedFaces",
                                       "inventedHits",
                                       "thinArea",
                                       "narrowArea"}));
  EXPECT_EQ(keys(json["output"]), (Names{"vertices",
                                         "triangles",
                                         "quads",
                                         "components",
                                         "eulerCharacteristic",
                                         "twoManifold",
                                         "manifold",
                                         "closed",
                                         "boundaryLoops",
                                         "volume",
                                         "area",
                                         "droppedPillows",
                                         "insertedVertices",
                                         "splitVertices",
                                         "linkVertices",
                                         "flippedEdges",
                                         "refinedHits",
                                         "droppedParts",
                                         "smallParts",
                                         "smallPartsVolume",
                                         "smallCavities",
                                         "smallCavitiesVolume",
                                         "smallHandles",
                                         "keptHandles",
                                         "droppedCrumbs",
                                         "inventedArea",
                                         "crossings",
                                         "selfIntersections"}));
  EXPECT_EQ(
      keys(json["check"]),
      (Names{"twoManifold", "manifold", "closed", "boundaryEdges", "nonManifoldEdges",
             "misorientedEdges", "nonManifoldVertices", "degenerateFaces", "duplicateFaces"}));
  EXPECT_EQ(keys(json["seconds"]), (Names{"read", "build", "extract", "write"}));

  EXPECT_EQ(json["input"]["vertices"], 8);
  EXPECT_EQ(json["input"]["triangles"], 12);
  EXPECT_EQ(json["input"]["closed"], true);
  EXPECT_EQ(json["input"]["components"], 1);
  EXPECT_EQ(json["input"]["flipped"], false);
  EXPECT_EQ(json["grid"]["depth"], 9);
  const Mesh result = mesh("out.ply");
  EXPECT_EQ(json["output"]["vertices"], result.positions.size());
  EXPECT_EQ(json["output"]["triangles"], result.triangles.size());
  EXPECT_EQ(json["output"]["eulerCharacteristic"], 2);
  EXPECT_EQ(json["output"]["twoManifold"], true);
  EXPECT_NEAR(json["output"]["volume"].get<double>(), 1, 1e-5);
  EXPECT_NEAR(json["output"]["area"].get<double>(), 6, 1e-4);
  EXPECT_GT(json["peakBytes"].get<double>(), 1e5);
  EXPECT_EQ(json["check"]["twoManifold"], true);
}

TEST_F(Cli, ReducesUnlessToldNotTo) {
  write("torus.ply", shapes::torus());
  const Json few = report("torus.ply -o few.obj --tolerance 0.02 --check");
  const Json all = report("torus.ply -o all.obj --tolerance 0.02 --no-reduce");
  EXPECT_EQ(keys(few["reduce"]), (Names{"trianglesBefore", "triangles", "collapses", "flips"}));
  EXPECT_EQ(few["reduce"]["triangles"], few["output"]["triangles"]);
  EXPECT_LT(2 * few["output"]["triangles"].get<int>(), all["output"]["triangles"].get<int>());
  EXPECT_EQ(few["output"]["selfIntersections"], 0);
  EXPECT_EQ(keys(few["seconds"]), (Names{"read", "build", "extract", "reduce", "write"}));
  EXPECT_EQ(mesh("few.obj").triangles.size(), few["output"]["triangles"]);
  EXPECT_FALSE(all.contains("reduce"));
  EXPECT_EQ(keys(all["seconds"]), (Names{"read", "build", "extract", "write"}));
  for (const Json& json : {few, all}) {
    EXPECT_EQ(json["grid"]["askedTolerance"], 0.02);
    EXPECT_NEAR(json["grid"]["tolerance"].get<double>(), 0.02, 1e-9);
    EXPECT_FALSE(json.contains("levels"));
  }
  const Outcome text = run("torus.ply --tolerance 0.02");
  EXPECT_NE(text.out.find("reduced  from "), std::string::npos) << text.out;

  // A saved grid gives as few.
  run("torus.ply --save-grid t.kdgrid --tolerance 0.02");
  const Json loaded = report("t.kdgrid");
  EXPECT_EQ(loaded["reduce"]["trianglesBefore"], few["reduce"]["trianglesBefore"]);
  EXPECT_EQ(loaded["grid"]["askedTolerance"], 0.02);
  EXPECT_NEAR(loaded["grid"]["tolerance"].get<double>(), 0.02, 1e-9);
  EXPECT_FALSE(report("t.kdgrid --no-reduce").contains("reduce"));
}

TEST_F(Cli, WritesAFileForEachLevel) {
  write("torus.ply", shapes::torus());
  const std::string levels = "torus.ply --tolerance 0.2 --target-triangles 400,320";
  const Json json = report(levels + " -o few.obj");
  EXPECT_EQ(files(), (std::set<std::string>{"cube.obj", "few.1.obj", "few.2.obj", "torus.ply"}));
  ASSERT_EQ(json["levels"].size(), 2u);
  for (int i : {0, 1}) {
    const Json& level = json["levels"][i];
    EXPECT_EQ(keys(level), (Names{"triangles", "file", "error"}));
    const std::string file = "few." + std::to_string(i + 1) + ".obj";
    EXPECT_EQ(level["file"], file);
    EXPECT_EQ(level["triangles"], mesh(file.c_str()).triangles.size());
    EXPECT_LE(level["triangles"], i == 0 ? 400 : 320);
  }
  EXPECT_EQ(json["output"]["triangles"], json["levels"][1]["triangles"]);
  EXPECT_NE(complaint(levels + " -o few.obj").find("few.1.obj"), std::string::npos);
  EXPECT_EQ(run(levels + " -o few.obj --force").status, 0);
  const Json unwritten = report(levels);
  EXPECT_TRUE(unwritten["levels"][1]["file"].is_null());
  const Json one = report("torus.ply -o one.obj --tolerance 0.2 --target-triangles 200");
  EXPECT_EQ(one["levels"][0]["file"], "one.obj");
  EXPECT_EQ(run(levels + " --out-dir ./ --format stl").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "torus.2.stl"));

  EXPECT_EQ(complaint(levels + " -o - --format obj"),
            "--target-triangles: standard output takes one level, not several");
  EXPECT_EQ(complaint("cube.obj --target-triangles 100,100"),
            "--target-triangles: '100' must be smaller than the number before");
  EXPECT_EQ(complaint("cube.obj --targetTriangles 9,x"),
            "--targetTriangles: 'x' is no whole number from 1 on");
  EXPECT_EQ(complaint("cube.obj --target-triangles 100,"),
            "--target-triangles: '' is no whole number from 1 on");
  EXPECT_EQ(complaint("cube.obj --no-reduce --target-triangles 100"),
            "--target-triangles: not together with --no-reduce");
  EXPECT_EQ(complaint("cube.obj --quads --target-triangles 100"),
            "--target-triangles: not together with --quads");
  EXPECT_EQ(complaint("cube.obj --strategy uniform --target-triangles 100"),
            "--target-triangles: not together with --strategy uniform");
}

TEST_F(Cli, ReportOmitsWhatWasNotDone) {
  const Json json = report("cube.obj" + kCoarse);
  EXPECT_EQ(keys(json),
            (Names{"input", "grid", "output", "lost", "warnings", "seconds", "peakBytes"}));
  EXPECT_EQ(keys(json["seconds"]), (Names{"read", "build", "extract"}));
  EXPECT_EQ(files(), (std::set<std::string>{"cube.obj"}));
}

TEST_F(Cli, InputInsideOutIsTurned) {
  write("inverted.obj", shapes::inverted(shapes::cube()));
  const Json json = report("inverted.obj" + kCoarse);
  EXPECT_EQ(json["input"]["flipped"], true);
  EXPECT_NEAR(json["output"]["volume"].get<double>(), 1, 1e-5);
  EXPECT_NE(run("inverted.obj" + kCoarse).out.find("turned inside out"), std::string::npos);
}

TEST_F(Cli, EveryOptionHasAnEffect) {
  write("turned.obj", shapes::rotated(shapes::cube(), {1, 2, 3}, 1));
  write("in.obj", shapes::overlapping_cubes());
  const std::string base = "in.obj --depth 12 --strategy ";
  std::set<std::pair<int, int>> sizes;
  for (const char* strategy : {"adaptive", "octree", "median", "uniform"}) {
    const Json json = report(std::string("turned.obj --depth 12 --strategy ") + strategy);
    EXPECT_EQ(json["output"]["twoManifold"], true) << strategy;
    sizes.emplace(json["grid"]["cells"].get<int>(), json["grid"]["hits"].get<int>());
  }
  EXPECT_EQ(sizes.size(), 4u);
  EXPECT_EQ(report("in.obj --depth 12")["grid"], report(base + "adaptive")["grid"]);
  EXPECT_EQ(report("in.obj --strategy uniform --depth=9")["grid"]["depth"], 9);

  // The octant in common counts once; with odd windings it is a cavity.
  const Json plain = report(base + "uniform");
  const double whole = plain["output"]["volume"].get<double>();
  const Json odd = report(base + "uniform --inside odd");
  EXPECT_LT(odd["output"]["volume"].get<double>(), whole - 0.05);
  const Json nonzero = report(base + "uniform --inside nonzero");
  EXPECT_EQ(nonzero["output"]["volume"].get<double>(), whole);

  EXPECT_EQ(plain["output"]["quads"], 0);
  const Json quads = report(base + "uniform --quads -o quads.obj");
  EXPECT_GT(quads["output"]["quads"].get<int>(), 0);
  const std::string text = read("quads.obj");
  EXPECT_TRUE(std::regex_search(text, std::regex("\nf \\d+ \\d+ \\d+ \\d+\n")));
  const Json loose = report("turned.obj --tolerance 0.05 --link-error 9 --strict off");
  const Json followed = report("turned.obj --tolerance 0.05 --link-error 0.0001 --strict embedded");
  EXPECT_EQ(loose["output"]["linkVertices"], 0);
  EXPECT_EQ(loose["output"]["crossings"], nullptr);
  EXPECT_GT(followed["output"]["linkVertices"].get<int>(), 0);
  EXPECT_EQ(followed["output"]["crossings"], 0);
  for (const char* pairing : {"trace", "hermite", "inside", "outside"}) {
    const Json json = report(base + "median --pairing " + pairing);
    EXPECT_EQ(json["output"]["twoManifold"], true) << pairing;
  }
}

TEST_F(Cli, MeshesAreJoinedFromLeftToRight) {
  write("bar.stl", shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 3)));
  const Json json = report(
      "cube.obj --union bar.stl --transform 1,0,0,0,0,1,0,0,0,0,1,0.5 --difference bar.stl "
      "--transform=0.5,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 -o out.obj --check");
  EXPECT_EQ(keys(json), (Names{"input", "operands", "grid", "output", "reduce", "warnings", "check",
                               "seconds", "peakBytes"}));
  ASSERT_EQ(json["operands"].size(), 3u);
  EXPECT_EQ(keys(json["operands"][2]), keys(json["input"]));
  EXPECT_EQ(json["input"]["triangles"], 36);
  EXPECT_EQ(json["output"]["twoManifold"], true);
  EXPECT_EQ(json["output"]["crossings"], 0) << "embedded, unless something else is asked for";
  EXPECT_NEAR(json["output"]["volume"].get<double>(), 1 * 1 * 3.5 - 0.5 * 3, 0.01);
}

TEST_F(Cli, ASavedGridIsAsGoodAsItsMesh) {
  write("torus.ply", shapes::torus());
  const Json built =
      report("torus.ply -o a.obj --save-grid torus.kdgrid --no-reduce --relative-tolerance 0.01");
  EXPECT_EQ(files(), (std::set<std::string>{"a.obj", "cube.obj", "torus.kdgrid", "torus.ply"}));
  const Json loaded = report("torus.kdgrid -o b.obj");
  EXPECT_FALSE(read("a.obj").empty());
  EXPECT_EQ(read("a.obj"), read("b.obj"));
  EXPECT_EQ(loaded["input"], built["input"]);
  EXPECT_EQ(loaded["output"], built["output"]);
  EXPECT_FALSE(loaded.contains("reduce"));  // as it was built, so nothing of the tolerance is left
  EXPECT_EQ(loaded["grid"]["hits"], built["grid"]["hits"]);
  EXPECT_EQ(loaded["seconds"]["build"], 0);
  EXPECT_EQ(keys(report("torus.kdgrid --save-grid again.kdgrid")["seconds"]),
            (Names{"read", "build", "extract", "write"}));
  EXPECT_EQ(read("again.kdgrid"), read("torus.kdgrid"));
  EXPECT_NE(run("torus.kdgrid").out.find("grid     loaded, depth"), std::string::npos);

  EXPECT_EQ(complaint("torus.kdgrid --depth 9 --tolerance 1"),
            "--tolerance: the grid in torus.kdgrid is built already");
  EXPECT_EQ(complaint("torus.ply --save-grid torus.bin"),
            "--save-grid: 'torus.bin' does not end in .kdgrid");
  EXPECT_NE(complaint("missing.kdgrid").find("missing.kdgrid: cannot be read"), std::string::npos);
  std::ofstream(folder_ / "bad.kdgrid") << read("torus.kdgrid").substr(0, 1000);
  EXPECT_NE(complaint("bad.kdgrid -o c.obj").find("bad.kdgrid: byte 28"), std::string::npos);
}

TEST_F(Cli, StatsDescribeTheInput) {
  // Open, with a face doubled: what cannot be built from can be described.
  Mesh mesh = shapes::open(shapes::cube());
  mesh.triangles.push_back(mesh.triangles[0]);
  write("open.obj", mesh);
  const Json json = report("open.obj --stats");
  EXPECT_EQ(keys(json), (Names{"input", "defects", "warnings", "seconds", "peakBytes"}));
  EXPECT_EQ(keys(json["input"]), (Names{"vertices", "triangles", "closed", "boundaryEdges",
                                        "nonManifoldEdges", "degenerateFaces", "components"}));
  EXPECT_EQ(keys(json["seconds"]), (Names{"read", "analyze"}));
  EXPECT_EQ(json["defects"]["flippedFaces"], 0);
  EXPECT_EQ(json["input"]["triangles"], 12);
  EXPECT_EQ(json["input"]["closed"], false);
  const Json& defects = json["defects"];
  EXPECT_EQ(defects["boundaryEdges"], 3);
  EXPECT_EQ(defects["boundaryLoops"], 1);
  EXPECT_EQ(defects["nonManifoldEdges"], 3);
  EXPECT_EQ(defects["duplicateFaces"], 1);
  EXPECT_EQ(defects["selfIntersections"], 1) << "the doubled faces";
  EXPECT_EQ(defects["openParts"], 1);
  const std::string text = run("open.obj --stats").out;
  EXPECT_NE(text.find("defects  3 open edges, 1 boundary loops, 3 edges with three or more faces"),
            std::string::npos)
      << text;
  EXPECT_NE(run("cube.obj --stats").out.find("defects  none\nparts    0 open, 1 closed, 0 of"),
            std::string::npos);

  // With an output both come, and the input's keys are those of the grid's report.
  const Json both = report("cube.obj --stats -o out.obj --check" + kCoarse);
  EXPECT_EQ(keys(both), (Names{"input", "defects", "grid", "output", "lost", "error", "warnings",
                               "check", "seconds", "peakBytes"}));
  EXPECT_EQ(both["input"], report("cube.obj" + kCoarse)["input"]);
  EXPECT_EQ(keys(both["seconds"]), (Names{"read", "analyze", "build", "extract", "write"}));
  EXPECT_TRUE(fs::exists(folder_ / "out.obj"));
  const Json alone = report("cube.obj --stats")["input"];
  for (const auto& item : alone.items()) EXPECT_EQ(item.value(), both["input"][item.key()]);

  complaint("open.obj --stats -o other.obj --inside positive");
  complaint("missing.obj --stats");
  EXPECT_EQ(complaint("cube.kdgrid --stats"), "--stats: cube.kdgrid is a grid, which has no faces");
}

TEST_F(Cli, PositionsDifferWhereVerticesLeaveTheirCells) {
  write("turned.obj", shapes::rotated(shapes::cube(), {1, 2, 3}, 1));
  const auto volume = [this](const std::string& options) {
    const Json json = report("turned.obj --split-error 9" + options + kCoarse);
    EXPECT_EQ(json["output"]["twoManifold"], true);
    return json["output"]["volume"].get<double>();
  };
  EXPECT_EQ(volume(""), volume(" --position constrained"));
  EXPECT_NE(volume(""), volume(" --position projection"));
  EXPECT_EQ(complaint("cube.obj --position best"),
            "--position: 'best' is none of constrained, projection");
}

TEST_F(Cli, NormalsGoIntoObjFiles) {
  EXPECT_EQ(run("cube.obj -o a.obj" + kCoarse).status, 0);
  EXPECT_EQ(read("a.obj").find("vn "), std::string::npos);
  const auto normals = [this](const std::string& options) {
    EXPECT_EQ(run("cube.obj -o a.obj --force --normals " + options + kCoarse).status, 0);
    const std::string text = read("a.obj");
    EXPECT_TRUE(std::regex_search(text, std::regex("\nf \\d+//\\d+ \\d+//\\d+ \\d+//\\d+\n")));
    int count = 0;
    for (std::size_t at = 0; (at = text.find("\nvn ", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(normals(""), 6);
  EXPECT_GT(normals("--crease-angle 180"), 6);
  EXPECT_EQ(complaint("cube.obj --crease-angle 181"),
            "--crease-angle: '181' is no number from 0 to 180");
}

TEST_F(Cli, TolerancesDecideHowMuchIsSplit) {
  write("ball.ply", shapes::icosphere(3));
  const auto triangles = [this](const std::string& options) {
    return report("ball.ply " + options)["output"]["triangles"].get<int>();
  };
  EXPECT_LT(triangles("--tolerance 0.1"), triangles("--tolerance 0.01"));
  EXPECT_LT(triangles("--relative-tolerance 1e-1"), triangles("--relative-tolerance=1e-2"));
  // An absolute tolerance of 0 is none.
  EXPECT_EQ(triangles("--tolerance 0 --relative-tolerance 0.1"),
            triangles("--relative-tolerance 0.1"));
}

TEST_F(Cli, CheckFailsOnWhatIsNotManifold) {
  // Two cubes that touch along an edge; without strictness their common edge has four faces.
  write("edge.obj", shapes::random_voxels(6, 0.5, 1));
  const std::string arguments = "edge.obj --depth 12 --strategy median --pairing inside";
  const Json strict = report(arguments + " --check");
  EXPECT_EQ(strict["check"]["twoManifold"], true);
  const Json raw = report(arguments + " --no-strict --check -o out.obj", 1);
  EXPECT_EQ(raw["check"]["twoManifold"], false);
  EXPECT_EQ(raw["output"]["twoManifold"], false);
  EXPECT_TRUE(fs::exists(folder_ / "out.obj"));
  const Outcome text = run(arguments + " --no-strict --check");
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.out.find("FAILED"), std::string::npos);
  EXPECT_EQ(run(arguments + " --no-strict").status, 0) << "nobody asked for a check";
}

TEST_F(Cli, ThickensOpenSurfaces) {
  write("open.obj", shapes::open(shapes::cube(), 2));
  const Json json = report("open.obj --thicken 0.1 --relative-tolerance 0.01 --check");
  EXPECT_EQ(json["check"]["twoManifold"], true);
  EXPECT_EQ(json["input"]["closed"], true);
  EXPECT_NE(complaint("open.obj --thicken -1").find("--thicken: "), std::string::npos);
}

TEST_F(Cli, MistakesInTheArguments) {
  EXPECT_EQ(complaint(""), "INPUT is required (--help lists the options)");
  EXPECT_EQ(complaint("cube.obj --strategy fast"),
            "--strategy: 'fast' is none of adaptive, octree, feature, median, uniform");
  EXPECT_EQ(complaint("cube.obj --inside even"),
            "--inside: 'even' is none of repair, positive, odd, nonzero, sheet");
  EXPECT_EQ(complaint("cube.obj --pairing near"),
            "--pairing: 'near' is none of trace, hermite, inside, outside");
  for (const char* depth : {"0", "61", "-1", "9.5", "x", "''", "99999999999999999999"}) {
    EXPECT_NE(complaint(std::string("cube.obj --depth ") + depth).find("--depth: "),
              std::string::npos)
        << depth;
  }
  for (const char* tolerance : {"-1", "x", "''", "nan", "inf", "1e999", "0,5", "1mm"}) {
    EXPECT_EQ(
        complaint(std::string("cube.obj --tolerance ") + tolerance).rfind("--tolerance: '", 0), 0u)
        << tolerance;
  }
  EXPECT_EQ(complaint("cube.obj --relative-tolerance -0.5"),
            "--relative-tolerance: '-0.5' is no number from 0 on");
  EXPECT_NE(complaint("cube.obj --depth").find("--depth"), std::string::npos);
  EXPECT_NE(complaint("cube.obj --bogus").find("--bogus"), std::string::npos);
  EXPECT_EQ(
      complaint("cube.obj other.obj -o out.obj"),
      "-o: it takes the result of one input, but there are 2; --out-dir takes those of several");
  EXPECT_NE(complaint("cube.obj -o out.xyz").find("out.xyz: "), std::string::npos);
  EXPECT_NE(complaint("cube.obj -o no/such/out.obj").find("no/such/out.obj: "), std::string::npos);
}

TEST_F(Cli, SheetsPassTheCheckWithABoundary) {
  write("open.obj", shapes::open(shapes::icosphere(2)));
  const std::string arguments = "open.obj -o out.ply --force --inside sheet --check";
  const Json json = report(arguments);
  EXPECT_EQ(json["input"]["boundaryLoops"], 1);
  EXPECT_EQ(json["output"]["twoManifold"], false);
  EXPECT_EQ(json["output"]["manifold"], true);
  EXPECT_EQ(json["output"]["boundaryLoops"], 1);
  EXPECT_EQ(json["check"]["manifold"], true);
  EXPECT_TRUE(check::check_mesh(mesh("out.ply")).manifold);
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("manifold with 1 boundary loops"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("passed: 2-manifold with boundary"), std::string::npos);
  // What a saved grid was built as is known.
  EXPECT_EQ(run("open.obj --save-grid open.kdgrid --inside sheet").status, 0);
  EXPECT_EQ(run("open.kdgrid --check").status, 0);
  EXPECT_NE(complaint("open.obj --inside positive").find("not closed"), std::string::npos)
      << "a solid must be";
}

TEST_F(Cli, ThatNothingIsLeftIsSaid) {
  for (const char* options : {"--tolerance 1e9", "--depth 1"}) {
    EXPECT_NE(complaint(std::string("cube.obj -o out.obj ") + options).find("nothing"),
              std::string::npos);
  }
}

TEST_F(Cli, BadInputIsNamedAndLeavesNothing) {
  EXPECT_EQ(complaint("none.obj -o out.obj").rfind("none.obj: cannot be read", 0), 0u);
  EXPECT_EQ(complaint("none.txt -o out.obj").rfind("none.txt: ", 0), 0u);
  EXPECT_EQ(complaint("\"$(printf 'a\\nb')\".obj").rfind("a b.obj: ", 0), 0u);

  write("bad.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"));
  EXPECT_EQ(complaint("bad.obj -o out.obj --json"),
            "bad.obj: line 4: vertex index 4 is out of range, there are 3 vertices");
  write("cut.ply", format_mesh(shapes::cube(), MeshFormat::kPly).substr(0, 300));
  EXPECT_EQ(complaint("cut.ply -o out.obj").rfind("cut.ply: byte ", 0), 0u);
  write("cut.stl", format_mesh(shapes::cube(), MeshFormat::kStl).substr(0, 300));
  EXPECT_EQ(complaint("cut.stl -o out.obj").rfind("cut.stl: byte 84: ", 0), 0u);
  write("cut.off", format_mesh(shapes::cube(), MeshFormat::kOff).substr(0, 60));
  EXPECT_EQ(complaint("cut.off -o out.obj").rfind("cut.off: line ", 0), 0u);

  write("empty.obj", std::string("# nothing\n"));
  EXPECT_EQ(complaint("empty.obj -o out.obj").rfind("empty.obj: ", 0), 0u);
  write("open.obj", shapes::open(shapes::cube()));
  EXPECT_EQ(complaint("open.obj -o out.obj --inside positive").rfind("open.obj: ", 0), 0u);
}

TEST_F(Cli, AnOldOutputSurvivesFailure) {
  write("out.obj", std::string("precious"));
  write("open.obj", shapes::open(shapes::cube()));
  complaint("open.obj -o out.obj --inside positive");
  EXPECT_EQ(read("out.obj"), "precious");
  EXPECT_EQ(complaint("cube.obj -o out.obj" + kCoarse),
            "out.obj: it exists already; --force overwrites it");
  EXPECT_EQ(read("out.obj"), "precious");
  EXPECT_EQ(run("cube.obj -o out.obj --force" + kCoarse).status, 0);
  EXPECT_TRUE(check::is_two_manifold(mesh("out.obj")));
}

TEST_F(Cli, InputAndOutputMayBeTheSameFile) {
  complaint("cube.obj -o cube.obj" + kCoarse);
  EXPECT_EQ(run("cube.obj -o cube.obj --force" + kCoarse).status, 0);
  EXPECT_GT(mesh("cube.obj").triangles.size(), 12u);
}

}  // namespace
}  // namespace kdm

#endif  // KDM_CLI_PATH
