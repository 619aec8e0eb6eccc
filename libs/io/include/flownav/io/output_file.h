#pragma once
#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "flownav/io/errors.h"

namespace flownav::io {

/// Creates `folder` unless it exists. Throws OutputError.
void make_output_folder(const std::filesystem::path& folder);

/// File with checked writes. All functions throw OutputError when it cannot be opened, written or closed.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path path);
    void write(std::string_view bytes);

    /// Flushes and closes the file. The destructor also closes it, but ignores errors.
    void close();

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, Closer> file_;
};

/// Writes a whole file. Throws OutputError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Gz file for MRPT's serialization that checks every write and the close; MRPT's own class ignores errors on
/// close. The gz header carries no time, so equal contents give equal bytes. Throws OutputError.
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

/// Appends one object in the format of a rawlog. Throws OutputError; an MRPT archive on the file would wrap
/// it into another exception.
void write_object(GzOutputFile& file, const mrpt::serialization::CSerializable& object);

}  // namespace flownav::io
