#include "recording.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "flownav/io/gz_member.h"
#include "flownav/io/output_file.h"

namespace flownav {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int error_number) {
    throw io::OutputError("cannot write " + file.string() + ": " +
                          std::generic_category().message(error_number));
}

/// True when `file` is a numbered continuation of `first`.
bool continues(const fs::path& file, const fs::path& first) {
    const std::string stem = file.stem().string();
    const std::string begin = first.stem().string() + '_';
    return file.extension() == first.extension() && stem.size() >= begin.size() + 3 &&
           stem.compare(0, begin.size(), begin) == 0 &&
           stem.find_first_not_of("0123456789", begin.size()) == std::string::npos;
}

/// Lists the files of an existing recording: the first and its continuations.
std::vector<fs::path> existing(const fs::path& first) {
    std::vector<fs::path> found;
    std::error_code error;
    if (fs::exists(first, error)) found.push_back(first);
    const fs::path folder = first.has_parent_path() ? first.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (continues(entry.path(), first)) found.push_back(entry.path());
    return found;
}

/// Removes an existing recording. Throws FileExists unless `overwrite` is set. Devices such as /dev/full
/// stay.
void prepare(const RecordingOptions& options) {
    for (const fs::path& file : existing(options.file)) {
        if (!fs::is_regular_file(file)) continue;
        if (!options.overwrite) {
            throw FileExists(file.string() + " exists: choose another file, or replace it with --overwrite");
        }
        std::error_code error;
        fs::remove(file, error);
        if (error) throw io::OutputError("cannot replace " + file.string() + ": " + error.message());
    }
}

}  // namespace

fs::path continuation(const fs::path& file, int number) {
    if (number == 0) return file;
    std::string digits = std::to_string(number);
    if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
    return file.parent_path() / (file.stem().string() + '_' + digits + file.extension().string());
}

Recording::Recording(RecordingOptions options) : options_(std::move(options)) {
    prepare(options_);
    open(options_.file);
}

Recording::~Recording() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void Recording::open(const fs::path& file) {
    const bool regular = !fs::exists(file);  // the file must not be created meanwhile
    descriptor_ =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (regular ? O_EXCL : 0), 0644);
    if (descriptor_ < 0) fail(file, errno);
    file_bytes_ = 0;
    file_has_objects_ = false;
    files_.push_back(file);
    write(io::gz_member({}, options_.gz_level));  // an empty recording is a valid gz file
}

void Recording::add(const std::vector<std::uint8_t>& object) {
    pending_.insert(pending_.end(), object.begin(), object.end());
}

void Recording::flush() {
    if (pending_.empty()) return;
    const auto member = io::gz_member(pending_, options_.gz_level);
    if (options_.max_bytes > 0 && file_has_objects_ && file_bytes_ + member.size() > options_.max_bytes) {
        finish_file();
        open(continuation(options_.file, static_cast<int>(files_.size())));
    }
    write(member);
    file_has_objects_ = true;
    pending_.clear();
}

void Recording::write(const std::vector<std::uint8_t>& member) {
    std::size_t done = 0;
    while (done < member.size()) {
        const ssize_t count = ::write(descriptor_, member.data() + done, member.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int error_number = count < 0 ? errno : ENOSPC;
            // Removes a partial member, which would be a damaged end.
            if (ftruncate(descriptor_, static_cast<off_t>(file_bytes_)) != 0)
                fail(files_.back(), error_number);
            fail(files_.back(), error_number);
        }
        done += static_cast<std::size_t>(count);
    }
    file_bytes_ += member.size();
}

void Recording::finish_file() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    // Devices and pipes cannot be synchronized.
    const bool synchronized = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
    const int sync_error = errno;
    const bool closed = ::close(descriptor) == 0;
    if (!synchronized) fail(files_.back(), sync_error);
    if (!closed) fail(files_.back(), errno);
    finished_files_bytes_ += file_bytes_;
    file_bytes_ = 0;
}

void Recording::close() {
    if (descriptor_ < 0) return;
    flush();
    finish_file();
}

}  // namespace flownav
