// SPDX-License-Identifier: MIT
// What all formats have in common: round trips, numbers, locale, files.
#include "kdmanifold/mesh_io.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <locale>

#include "support/io_fixtures.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

namespace fs = std::filesystem;

constexpr MeshFormat kFormats[] = {MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kPly,
                                   MeshFormat::kOff};

Vec3 as_floats(const Vec3& p) {
  // GCC 12 would drop the rounding if it could see it.
  volatile const float x = static_cast<float>(p.x()), y = static_cast<float>(p.y()),
                       z = static_cast<float>(p.z());
  return {double{x}, double{y}, double{z}};
}

// Text is the shortest decimal that rounds to the float, so it is compared as a float.
void expect_same(const Mesh& mesh, const Mesh& again, MeshFormat format) {
  ASSERT_EQ(again.triangles.size(), mesh.triangles.size() + 2 * mesh.quads.size());
  ASSERT_EQ(again.source_faces.size(), again.triangles.size());
  std::vector<Triangle> triangles = mesh.triangles;
  for (const Quad& q : mesh.quads) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (format != MeshFormat::kStl) {
        ASSERT_EQ(again.triangles[t][k], triangles[t][k]);
      }
      ASSERT_EQ(as_floats(again.positions[again.triangles[t][k]]),
                as_floats(mesh.positions[triangles[t][k]]));
    }
  }
}

TEST(MeshIo, RoundTripsOfShapes) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    if (shape.mesh.triangles.size() > 1000) continue;  // the small ones have all there is
    for (const MeshFormat format : kFormats) {
      SCOPED_TRACE(shape.name);
      const std::string bytes = format_mesh(shape.mesh, format);
      const Mesh again = parse_mesh(bytes, format);
      expect_same(shape.mesh, again, format);
      EXPECT_EQ(format_mesh(again, format), bytes);
    }
  }
}

TEST(MeshIo, RoundTripsOfAwkwardNumbers) {
  Mesh mesh;
  const double numbers[] = {0.0,        -0.0,           0.1,    1.0 / 3, -1e-7,
                            1e-45,      1.17549435e-38, 3.4e38, -3.4e38, 16777216,
                            16777217.0, 123456.7,       1e10,   -1e21,   1e-10,
                            9.999999,   0.0001234,      1e16,   0.3f,    5e-324};
  for (const double x : numbers) {
    for (const double y : numbers) mesh.positions.push_back({x, y, x + y / 3});
  }
  for (Index i = 0; i + 2 < mesh.positions.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  for (Vec3& p : mesh.positions) {
    if (std::abs(p.z()) > 3.4e38) p.z() = 1;
  }
  for (const MeshFormat format : kFormats) {
    const Mesh again = parse_mesh(format_mesh(mesh, format), format);
    expect_same(mesh, again, format);
  }
}

TEST(MeshIo, RoundTripsOfQuads) {
  const Mesh mesh = io_test::pyramid();
  for (const MeshFormat format : kFormats) {
    const Mesh again = parse_mesh(format_mesh(mesh, format), format);
    expect_same(mesh, again, format);
    if (format == MeshFormat::kStl) continue;
    EXPECT_EQ(again.source_faces, (std::vector<Index>{0, 1, 2, 3, 4, 4}));
  }
}

TEST(MeshIo, EmptyMesh) {
  for (const MeshFormat format : kFormats) {
    const Mesh again = parse_mesh(format_mesh({}, format), format);
    EXPECT_TRUE(again.positions.empty());
    EXPECT_TRUE(again.triangles.empty());
  }
}

TEST(MeshIo, NumbersDoNotDependOnTheLocale) {
  const Mesh mesh = io_test::pyramid();
  std::vector<std::string> files;
  for (const MeshFormat format : kFormats) files.push_back(format_mesh(mesh, format));

  // A C++ locale with comma and grouping exists everywhere, a C locale perhaps not.
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"}) {
    if (std::setlocale(LC_ALL, name)) break;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(format_mesh(mesh, kFormats[i]), files[i]);
    expect_same(mesh, parse_mesh(files[i], kFormats[i]), kFormats[i]);
  }
  EXPECT_EQ(parse_mesh("v 1.5 2.25 3\n", MeshFormat::kObj).positions[0], Vec3(1.5, 2.25, 3));
  EXPECT_EQ(
      io_test::parse_fault("v 1.5 2,25 3\n", MeshFormat::kObj),
      "in: line 1: coordinate y is '2,25', with a decimal comma; a decimal point is expected");
  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(before);
}

TEST(MeshIo, FormatFromPath) {
  EXPECT_EQ(format_from_path("a.obj"), MeshFormat::kObj);
  EXPECT_EQ(format_from_path("/some.where/B.StL"), MeshFormat::kStl);
  EXPECT_EQ(format_from_path("x.y.PLY"), MeshFormat::kPly);
  EXPECT_EQ(format_from_path("c:\\d\\e.off"), MeshFormat::kOff);
  for (const char* path : {"", "obj", "a.obj.gz", "dir.obj/file", "a."}) {
    try {
      format_from_path(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kIoError);
    }
  }
}

TEST(MeshIo, RefusesWhatFilesCannotHold) {
  const auto fault = [](const Mesh& mesh) -> std::string {
    for (const MeshFormat format : kFormats) {
      EXPECT_THROW(format_mesh(mesh, format), Error);
    }
    try {
      format_mesh(mesh, MeshFormat::kObj);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidMesh);
      return error.what();
    }
    return "";
  };
  Mesh mesh = io_test::pyramid();
  mesh.positions[3].y() = 1e39;
  EXPECT_EQ(fault(mesh),
            "positions[3].y is 1e+39, which is no finite 32-bit number; scale the mesh down");
  mesh.positions[3].y() = std::nan("");
  EXPECT_EQ(fault(mesh),
            "positions[3].y is nan, which is no finite 32-bit number; scale the mesh down");
  mesh = io_test::pyramid();
  mesh.triangles[1][2] = 5;
  EXPECT_EQ(fault(mesh), "triangles[1] names vertex 5, but there are 5 vertices");
  mesh = io_test::pyramid();
  mesh.quads[0][0] = kNone;
  EXPECT_EQ(fault(mesh), "quads[0] names vertex 4294967295, but there are 5 vertices");
}

// A folder of its own for each test, gone afterwards.
class MeshFiles : public ::testing::Test {
 protected:
  MeshFiles() {
    const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("kdmanifold-" + std::string(info->name()) + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  ~MeshFiles() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static ErrorCode code_of(const std::function<void()>& call, const std::string& start) {
    try {
      call();
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(start, 0), 0u) << error.what();
      return error.code();
    }
    ADD_FAILURE() << "no error: " << start;
    return ErrorCode::kInternal;
  }

  fs::path folder_;
};

TEST_F(MeshFiles, RoundTrips) {
  const Mesh mesh = io_test::pyramid();
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.off", "b.OBJ"}) {
    write_mesh(path(name), mesh);
    write_mesh(path(name), mesh);  // again, over the first
    const Mesh again = read_mesh(path(name));
    expect_same(mesh, again, format_from_path(name));
  }
  EXPECT_EQ(files(), 5u);
}

TEST_F(MeshFiles, ReadingErrorsNameTheFile) {
  EXPECT_EQ(code_of([&] { read_mesh(path("none.obj")); }, path("none.obj")), ErrorCode::kIoError);
  EXPECT_EQ(code_of([&] { read_mesh(path("none.txt")); }, path("none.txt")), ErrorCode::kIoError);
  fs::create_directory(folder_ / "folder.obj");
  EXPECT_EQ(code_of([&] { read_mesh(path("folder.obj")); }, path("folder.obj")),
            ErrorCode::kIoError);
  std::ofstream(path("bad.obj")) << "v 0 0 0\nf 1 2 3\n";
  EXPECT_EQ(code_of([&] { read_mesh(path("bad.obj")); },
                    path("bad.obj") + ": line 2: vertex index 3 is out of range"),
            ErrorCode::kParseError);
}

TEST_F(MeshFiles, FailedWritesLeaveNothingBehind) {
  Mesh bad = io_test::pyramid();
  bad.triangles[0][0] = 77;
  EXPECT_EQ(code_of([&] { write_mesh(path("a.obj"), bad); }, "triangles[0]"),
            ErrorCode::kInvalidMesh);
  EXPECT_EQ(code_of([&] { write_mesh(path("no/such/a.obj"), io_test::pyramid()); },
                    path("no/such/a.obj")),
            ErrorCode::kIoError);
  EXPECT_EQ(files(), 0u);
  // The target cannot be replaced: the temporary file must go, too.
  fs::create_directories(folder_ / "taken.obj" / "inside");
  EXPECT_EQ(code_of([&] { write_mesh(path("taken.obj"), io_test::pyramid()); }, path("taken.obj")),
            ErrorCode::kIoError);
  EXPECT_EQ(files(), 1u);
}

TEST_F(MeshFiles, FailedWritesKeepTheOldFile) {
  write_mesh(path("a.obj"), io_test::pyramid());
  Mesh bad = io_test::pyramid();
  bad.positions[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_mesh(path("a.obj"), bad), Error);
  EXPECT_EQ(read_mesh(path("a.obj")).triangles.size(), 6u);
}

TEST_F(MeshFiles, LeftOverTemporaryFilesAreNotTouched) {
  std::ofstream(path("a.obj.0.part")) << "of another run";
  write_mesh(path("a.obj"), io_test::pyramid());
  EXPECT_EQ(fs::file_size(path("a.obj.0.part")), 14u);
  EXPECT_EQ(files(), 2u);
}

}  // namespace
}  // namespace kdm
