#pragma once
#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

namespace flownav::testing {

/// A display without a screen, for as long as this lives: Xvfb, which keeps its picture in a file.
class XDisplay {
  public:
    /// Null when there is no Xvfb. `folder` takes its files.
    static std::unique_ptr<XDisplay> start(const std::filesystem::path& folder);
    ~XDisplay();
    XDisplay(const XDisplay&) = delete;
    XDisplay& operator=(const XDisplay&) = delete;

    const std::string& name() const { return name_; }

    /// What is on it, 8-bit BGR.
    cv::Mat screenshot() const;

  private:
    XDisplay(pid_t process, std::string name, std::filesystem::path file)
        : process_(process), name_(std::move(name)), file_(std::move(file)) {}

    pid_t process_;
    std::string name_;
    std::filesystem::path file_;
};

}  // namespace flownav::testing
