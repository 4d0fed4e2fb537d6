// SPDX-License-Identifier: MIT
// Patterns of file names, and what mistyped words may mean.
#ifdef KDM_CLI_PATH

#include <gtest/gtest.h>

#include "cli/glob.h"
#include "cli/suggest.h"

namespace kdm::cli {
namespace {

TEST(Glob, NamesFitPatterns) {
  struct Case {
    const char* name;
    const char* pattern;
    bool fits;
  };
  for (const Case& c : {Case{"a.obj", "a.obj", true},
                        {"a.obj", "*.obj", true},
                        {"a.obj", "*", true},
                        {"a.obj", "*.stl", false},
                        {"a.obj", "?.obj", true},
                        {"ab.obj", "?.obj", false},
                        {"abcabd", "*ab?", true},
                        {"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaab", "*a*a*a*a*a*a*a*c", false},
                        {"", "*", true},
                        {"", "?", false},
                        {"a", "", false},
                        {"b", "[a-c]", true},
                        {"d", "[a-c]", false},
                        {"d", "[!a-c]", true},
                        {"d", "[^d]", false},
                        {"-", "[a-]", true},
                        {"]", "[]]", true},
                        {"[a", "[a", true},
                        {"\u00e9.obj", "?.obj", true},
                        {"\u00e9", "[\u00e8-\u00ea]", true},
                        {"\xff", "?", true},
                        {".hidden", "*", false},
                        {".hidden", ".*", true},
                        {".hidden", "?hidden", false}}) {
    EXPECT_EQ(fits(c.name, c.pattern), c.fits) << c.name << ' ' << c.pattern;
  }
  EXPECT_TRUE(is_pattern("a*") && is_pattern("a?") && is_pattern("[a"));
  EXPECT_FALSE(is_pattern("a.obj") || is_pattern("-"));
}

TEST(Suggest, TheNearestWordIsMeant) {
  const std::vector<std::string> words = {
      "tolerance", "relative-tolerance", "depth", "no-unfold", "out-dir", "output"};
  EXPECT_EQ(nearest("tolerence", words), "tolerance");
  EXPECT_EQ(nearest("tolernace", words), "tolerance") << "neighbours change places";
  EXPECT_EQ(nearest("dpth", words), "depth");
  EXPECT_EQ(nearest("tol", words), "tolerance") << "a beginning";
  EXPECT_EQ(nearest("unfold", words), "no-unfold") << "a part";
  EXPECT_EQ(nearest("ou", words), "") << "too little to tell";
  EXPECT_EQ(nearest("unheard-of", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest(std::string(100000, 'a'), words), "");
  EXPECT_EQ(did_you_mean("dept", words), "; did you mean depth?");
  EXPECT_EQ(did_you_mean("xyz", words), "");
}

}  // namespace
}  // namespace kdm::cli

#endif  // KDM_CLI_PATH
