#pragma once

#include <filesystem>
#include <string>

namespace flownav::regress {

/// A new folder for exclusive use, removed by the destructor unless it was moved away. A lock marks it as in
/// use; a child process that inherits lock() keeps the lock while it lives.
class ScratchFolder {
  public:
    ScratchFolder(const std::filesystem::path& parent, const std::string& name);
    ~ScratchFolder();
    ScratchFolder(ScratchFolder&& other) noexcept;
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ScratchFolder& operator=(ScratchFolder&&) = delete;

    const std::filesystem::path& path() const { return path_; }
    int lock() const { return lock_; }  ///< file descriptor, closed on exec

  private:
    std::filesystem::path path_;
    int lock_ = -1;
};

/// The results of a run on disk: done/ID and failed/ID, each complete or absent, even after a crash. Any
/// number of processes on any number of machines may use the same folder. All functions throw OutputError
/// when the folder cannot be written.
class Store {
  public:
    /// Creates missing folders.
    explicit Store(std::filesystem::path root);

    /// True when done/ID exists and was made with `key`.
    bool is_done(const std::string& id, const std::string& key) const;

    ScratchFolder scratch(const std::string& id) const;

    /// Moves the complete `result` to done/ID and removes failed/ID. An existing done/ID with the same key
    /// stays, unless `force`; one with another key is replaced.
    void commit_done(const ScratchFolder& result, const std::string& id, const std::string& key,
                     bool force) const;

    /// Moves `result` to failed/ID and removes a done/ID with another key. When done/ID has the same `key`,
    /// it stays and `result` is dropped.
    void commit_failed(const ScratchFolder& result, const std::string& id, const std::string& key) const;

    /// Removes the files of ended processes from tmp/; none on a file system without locks.
    void remove_left_overs() const;

  private:
    std::filesystem::path folder(const char* kind, const std::string& id) const { return root_ / kind / id; }
    void discard(const std::filesystem::path& folder) const;
    bool move(const std::filesystem::path& from, const std::filesystem::path& to) const;

    std::filesystem::path root_;
};

/// Name of the file in done/ID and failed/ID that holds the result.
constexpr auto result_file = "result.json";
constexpr auto failure_file = "failure.json";

}  // namespace flownav::regress
