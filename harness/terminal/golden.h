// For tests: text against the file that it was once, in golden/ beside the sources. A test that is run with
// FILLRULE_RENEW_GOLDEN=1 writes the files anew instead; what `git diff` shows then is what a reader of the terminal
// sees change.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace fillrule::terminal {

inline void expect_golden(const std::string& name, const std::string& text) {
  const std::string path = FILLRULE_SOURCE_DIR "/harness/terminal/golden/" + name;
  if (std::getenv("FILLRULE_RENEW_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << text;
    return;
  }
  std::ifstream file(path, std::ios::binary);
  ASSERT_TRUE(file) << path << " cannot be read";
  std::ostringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(text, golden.str()) << path;
}

}  // namespace fillrule::terminal
