#include "flownav/io/output_file.h"

#include <zlib.h>

#include <cerrno>
#include <system_error>
#include <vector>

namespace flownav::io {

namespace {

constexpr const char* compression = "wb6";

std::string reason(int error_number) {
    return error_number == 0 ? "unknown error" : std::generic_category().message(error_number);
}

[[noreturn]] void fail(const std::filesystem::path& path, int error_number) {
    throw OutputError("cannot write " + path.string() + ": " + reason(error_number));
}

}  // namespace

void make_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw OutputError("cannot make the folder " + folder.string() + ": " + error.message());
    if (!std::filesystem::is_directory(folder, error)) {
        throw OutputError("cannot make the folder " + folder.string() + ": it exists and is no folder");
    }
}

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
    errno = 0;
    file_.reset(std::fopen(path_.c_str(), "wbe"));
    if (!file_) fail(path_, errno);
}

void OutputFile::write(std::string_view bytes) {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail(path_, errno);
}

void OutputFile::close() {
    if (!file_) return;
    errno = 0;
    if (std::fclose(file_.release()) != 0) fail(path_, errno);
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.close();
}

GzOutputFile::GzOutputFile(std::filesystem::path path) : path_(std::move(path)) {
    errno = 0;
    file_ = gzopen(path_.c_str(), compression);
    if (file_ == nullptr) fail(path_, errno);
}

GzOutputFile::~GzOutputFile() {
    if (file_ != nullptr) gzclose(static_cast<gzFile>(file_));
}

size_t GzOutputFile::Write(const void* buffer, size_t count) {
    errno = 0;
    if (gzfwrite(buffer, 1, count, static_cast<gzFile>(file_)) != count) fail(path_, errno);
    written_ += count;
    return count;
}

void GzOutputFile::close() {
    if (file_ == nullptr) return;
    auto* file = static_cast<gzFile>(file_);
    file_ = nullptr;
    errno = 0;
    if (gzclose(file) != Z_OK) fail(path_, errno);
}

void write_object(GzOutputFile& file, const mrpt::serialization::CSerializable& object) {
    std::vector<std::uint8_t> bytes;
    mrpt::serialization::ObjectToOctetVector(&object, bytes);
    file.Write(bytes.data(), bytes.size());
}

size_t GzOutputFile::Read(void* /*buffer*/, size_t /*count*/) {
    throw std::logic_error("GzOutputFile cannot read");
}

uint64_t GzOutputFile::Seek(int64_t /*offset*/, TSeekOrigin /*origin*/) {
    throw std::logic_error("GzOutputFile cannot seek");
}

}  // namespace flownav::io
