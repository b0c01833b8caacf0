#include <gtest/gtest.h>

#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

using Points = std::vector<Eigen::Vector3f>;

std::string vtk_header(const std::string& form, const std::string& rest) {
  return "# vtk DataFile Version 3.0\na title\n" + form + "\nDATASET POLYDATA\n" + rest;
}

TEST(ReadVtk, ReadsTextHoweverItIsBroken) {
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("ASCII", "POINTS 2 float\n1 2 3 4\n5\n\n 6 \nVERTICES 1 2\n1 0\n")).points,
            (Points{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("ASCII", "POINTS 1 double\n1 2 3")).size(), 1u);
}

TEST(ReadVtk, ReadsBinary) {
  std::string floats, doubles;
  for (const float value : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}) {
    floats += big(value);
    doubles += big(static_cast<double>(value));
  }
  const Points expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("BINARY", "POINTS 2 float\n" + floats + "\nVERTICES 1 2\n")).points,
            expected);
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("BINARY", "POINTS 2 double\n" + doubles)).points, expected);
  const std::string grid = "# vtk DataFile Version 4.2\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 double\n";
  EXPECT_EQ(read_bytes("a.vtk", grid + doubles).points, expected);
}

TEST(ReadVtk, SkipsFieldsBeforeThePoints) {
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("ASCII",
                                           "FIELD FieldData 2\nTIME 1 1 double\n0.5\nN 2 2 int\n1 2\n3 4\nMETADATA\n"
                                           "INFORMATION 0\n\nPOINTS 1 float\n1 2 3\n"))
                .size(),
            1u);
  EXPECT_EQ(read_bytes("a.vtk", vtk_header("BINARY", "FIELD FieldData 1\nTIME 1 1 double\n" + big(0.5) +
                                                         "\nPOINTS 1 float\n" + big(1.0f) + big(2.0f) + big(3.0f)))
                .size(),
            1u);
}

TEST(ReadVtk, RefusesDamage) {
  const auto error = [](const std::string& rest, const std::string& form = "ASCII") {
    return error_of("a.vtk", vtk_header(form, rest));
  };
  ASSERT_EQ(error("POINTS 1 float\n1 2 3\n"), "");
  EXPECT_NE(error("POINTS 1 float\n1 2 3\n", "XML").find(":3: 'XML'"), std::string::npos);
  EXPECT_NE(error("POINTS one float\n1 2 3\n").find(":5: 'one'"), std::string::npos);
  EXPECT_NE(error("POINTS 1 bit\n1 2 3\n").find("'bit'"), std::string::npos);
  EXPECT_NE(error("POINTS 1 float\n1 x 3\n").find(":6: 'x'"), std::string::npos);
  EXPECT_NE(error("POINTS 2 float\n1 2 3\n4 5\n").find("promises 2"), std::string::npos);
  EXPECT_NE(error("POINTS 6148914691236517206 float\n1 2 3\n").find("promises"), std::string::npos);
  EXPECT_NE(error("POINTS 4000000000 float\n1 2 3\n", "BINARY").find("promises"), std::string::npos);
  EXPECT_NE(error("POINTS 0 float\n").find("holds no point"), std::string::npos);
  EXPECT_NE(error("VERTICES 1 2\n1 0\n").find("'VERTICES' in place of POINTS"), std::string::npos);
  EXPECT_NE(error("").find("has no POINTS"), std::string::npos);
  EXPECT_NE(error("FIELD f 1\nTIME 4294967296 4294967297 double\n0\n").find("no array"), std::string::npos);
  EXPECT_NE(error("FIELD f 18446744073709551615\n").find("no array"), std::string::npos);
}

}  // namespace
}  // namespace scanway
