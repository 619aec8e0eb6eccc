#pragma once
#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

namespace flownav::testing {

/// A virtual display by Xvfb, which keeps its picture in a file; ends with the object.
class XDisplay {
  public:
    /// Starts Xvfb with its files in `folder`. Null when Xvfb is missing.
    static std::unique_ptr<XDisplay> start(const std::filesystem::path& folder);
    ~XDisplay();
    XDisplay(const XDisplay&) = delete;
    XDisplay& operator=(const XDisplay&) = delete;

    const std::string& name() const { return name_; }

    /// The content of the display, 8-bit BGR.
    cv::Mat screenshot() const;

  private:
    XDisplay(pid_t process, std::string name, std::filesystem::path file)
        : process_(process), name_(std::move(name)), file_(std::move(file)) {}

    pid_t process_;
    std::string name_;
    std::filesystem::path file_;
};

}  // namespace flownav::testing
