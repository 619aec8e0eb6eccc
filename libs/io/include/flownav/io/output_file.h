#pragma once
#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flownav::io {

/// Something could not be written; what() names the file or folder and the reason.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Makes sure that `folder` exists. Throws OutputError.
void make_output_folder(const std::filesystem::path& folder);

/// A file whose every write is checked. Throws OutputError when it cannot be opened, written or closed.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path path);
    void write(std::string_view bytes);

    /// Flushes and closes. Without it the destructor closes, but then nobody learns about an error.
    void close();

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, Closer> file_;
};

/// Writes a whole file at once.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// A gz file for MRPT's serialization whose every write, and the close, is checked; MRPT's own class swallows
/// errors on close. The gz header carries no time, so that the same content gives the same bytes.
class GzOutputFile : public mrpt::io::CStream {
  public:
    explicit GzOutputFile(std::filesystem::path path);
    ~GzOutputFile() override;
    GzOutputFile(const GzOutputFile&) = delete;
    GzOutputFile& operator=(const GzOutputFile&) = delete;

    size_t Write(const void* buffer, size_t count) override;
    void close();

    size_t Read(void* buffer, size_t count) override;                             ///< not supported: throws
    uint64_t Seek(int64_t offset, TSeekOrigin origin = sFromBeginning) override;  ///< not supported: throws
    uint64_t getTotalBytesCount() const override { return written_; }
    uint64_t getPosition() const override { return written_; }

  private:
    std::filesystem::path path_;
    void* file_ = nullptr;  ///< a gzFile
    uint64_t written_ = 0;
};

/// Appends one object as a rawlog has it. An archive on the file would wrap the OutputError of a full disk
/// into an exception of MRPT's own.
void write_object(GzOutputFile& file, const mrpt::serialization::CSerializable& object);

}  // namespace flownav::io
