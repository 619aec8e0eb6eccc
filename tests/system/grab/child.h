#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace flownav::testing {

/// A program that runs beside the test, without a terminal and with closed standard input.
class Child {
  public:
    /// `file_bytes_max` limits the size of its files, to simulate a full disk; 0: no limit.
    Child(const std::string& program, const std::vector<std::string>& arguments, std::filesystem::path log,
          std::uint64_t file_bytes_max = 0);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void signal(int number) const;
    bool running();

    /// Waits for its end. Returns the exit status, or minus the number of the signal that ended it.
    int wait();

    std::string log() const;  ///< output so far

  private:
    std::filesystem::path log_;
    pid_t process_ = -1;
    bool ended_ = false;
    int status_ = 0;
};

}  // namespace flownav::testing
