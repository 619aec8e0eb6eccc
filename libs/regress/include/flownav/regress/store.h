#pragma once

#include <filesystem>
#include <string>

namespace flownav::regress {

/// A new folder that nobody else uses, gone with this object unless it was moved away. A lock shows others
/// that it is in use; a child that inherits lock() keeps it for as long as it lives.
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

/// The results of a run on disk: done/ID and failed/ID, each complete or not there, whatever ends whom. Any
/// number of processes on any number of machines may use the same folder. Everything throws OutputError when
/// it cannot be written.
class Store {
  public:
    /// Makes the folders that are missing.
    explicit Store(std::filesystem::path root);

    /// Whether done/ID was made with `key`.
    bool is_done(const std::string& id, const std::string& key) const;

    ScratchFolder scratch(const std::string& id) const;

    /// Makes `result`, which is complete, done/ID, and forgets failed/ID. Whoever comes second with the same
    /// key changes nothing, unless `force`; a result with another key gives way.
    void commit_done(const ScratchFolder& result, const std::string& id, const std::string& key,
                     bool force) const;

    /// Makes `result` failed/ID; a done/ID with another key is forgotten. Where done/ID was made with `key`,
    /// it stays and the failure is dropped.
    void commit_failed(const ScratchFolder& result, const std::string& id, const std::string& key) const;

    /// Removes what ended processes left in tmp/. Where the file system knows no locks, all is left there.
    void remove_left_overs() const;

  private:
    std::filesystem::path folder(const char* kind, const std::string& id) const { return root_ / kind / id; }
    void discard(const std::filesystem::path& folder) const;
    bool move(const std::filesystem::path& from, const std::filesystem::path& to) const;

    std::filesystem::path root_;
};

/// The file of done/ID, and of failed/ID, that tells what came of it.
constexpr auto result_file = "result.json";
constexpr auto failure_file = "failure.json";

}  // namespace flownav::regress
