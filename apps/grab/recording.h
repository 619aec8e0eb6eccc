#pragma once
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace flownav {

/// The recording would overwrite a file; what() names it.
struct FileExists : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct RecordingOptions {
    std::filesystem::path file;
    std::uint64_t max_bytes = 0;  ///< limit of one compressed file; 0: no limit
    bool overwrite = false;       ///< replaces FILE and the numbered files of an earlier recording with it
    int gz_level = 1;
};

/// A rawlog that grows by whole members of a gz file. Each member is passed to the kernel in one write, so
/// flushed data survives a crash of the program. When the next member would exceed `max_bytes`, the file is
/// closed and FILE_001, FILE_002, ... follow; each can be read by itself. Throws OutputError naming the file;
/// every file then still ends with its last whole member.
class Recording {
  public:
    /// Opens FILE, an empty recording until the first flush(). Throws FileExists unless `overwrite` is set.
    explicit Recording(RecordingOptions options);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// Adds one serialized object to the current member.
    void add(const std::vector<std::uint8_t>& object);

    /// Finishes the current member, unless it is empty, and writes it.
    void flush();

    /// Flushes the recording and synchronizes the file with the disk.
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
    std::uint64_t file_bytes_ = 0;       ///< size of whole members in the open file
    bool file_has_objects_ = false;
    std::uint64_t finished_files_bytes_ = 0;
    std::vector<std::filesystem::path> files_;
};

/// Name of the continuation `number` of FILE.rawlog: FILE_001.rawlog and so on; FILE itself for 0.
std::filesystem::path continuation(const std::filesystem::path& file, int number);

}  // namespace flownav
