#pragma once
#include <filesystem>
#include <string>

namespace flownav::io {

/// File names of a folder's images as CCameraSensor forms them: a printf format with one number.
class NumberedFiles {
  public:
    /// Throws ConfigError when `format` does not hold exactly one number such as %05d.
    NumberedFiles(std::filesystem::path folder, const std::string& format);

    std::filesystem::path file(int index) const;
    bool exists(int index) const;

  private:
    std::filesystem::path folder_;
    std::string before_, after_;
    int width_ = 0;
    bool zeros_ = false;
};

}  // namespace flownav::io
