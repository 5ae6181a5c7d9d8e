// For tests: a new folder that goes, with all that is in it, at the end of the scope. Its name is nobody else's, as
// tests run side by side, in several checkouts and builds too.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace fillrule {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "fillrule_XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) ADD_FAILURE() << path_ << " cannot be made";
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  // Of a file or folder in it.
  [[nodiscard]] std::string path(std::string_view name) const { return (path_ + "/").append(name); }

 private:
  std::string path_;
};

}  // namespace fillrule
