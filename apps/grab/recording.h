#pragma once
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace flownav {

/// A file that would be overwritten; what() names it.
struct FileExists : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct RecordingOptions {
    std::filesystem::path file;
    std::uint64_t max_bytes = 0;  ///< of one file, as it lies on the disk; 0: no limit
    bool overwrite = false;       ///< replace FILE, and the numbered files of an earlier recording with it
    int gz_level = 1;
};

/// A rawlog that grows by whole members of a gz file, each handed to the kernel in one piece as soon as it is
/// finished: whatever ends the program, what was flushed can be read. When the next member would pass
/// `max_bytes`, the file is closed and FILE_001, FILE_002, ... follow; each can be read by itself.
/// Throws OutputError naming the file; then every file still ends with its last whole member.
class Recording {
  public:
    /// Opens FILE, an empty recording until the first flush(). Throws FileExists unless told to overwrite.
    explicit Recording(RecordingOptions options);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// Adds one serialized object to the member that is being made.
    void add(const std::vector<std::uint8_t>& object);

    /// Finishes the member, if there is anything in it, and writes it.
    void flush();

    /// Flushes and has the disk confirm that it holds the file.
    void close();

    std::uint64_t pending_bytes() const { return pending_.size(); }
    std::uint64_t written_bytes() const { return finished_files_bytes_ + file_bytes_; }
    const std::vector<std::filesystem::path>& files() const { return files_; }

  private:
    void open(const std::filesystem::path& file);
    void write(const std::vector<std::uint8_t>& member);
    void finish_file();

    RecordingOptions options_;
    int descriptor_ = -1;
    std::vector<std::uint8_t> pending_;  ///< objects, uncompressed
    std::uint64_t file_bytes_ = 0;       ///< of whole members in the open file
    bool file_has_objects_ = false;
    std::uint64_t finished_files_bytes_ = 0;
    std::vector<std::filesystem::path> files_;
};

/// FILE_001.rawlog and so on, the continuation `number` of FILE.rawlog; FILE itself for 0.
std::filesystem::path continuation(const std::filesystem::path& file, int number);

}  // namespace flownav
