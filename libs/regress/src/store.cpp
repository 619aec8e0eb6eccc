#include "flownav/regress/store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "flownav/io/output_file.h"
#include "flownav/regress/result.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

/// Creates a new folder whose name begins with `name`.
fs::path make_unique_folder(const fs::path& parent, const std::string& name) {
    std::string path = parent / (name + ".XXXXXX");
    if (mkdtemp(path.data()) == nullptr)
        throw io::OutputError("cannot make a folder in " + parent.string() + ": " +
                              std::generic_category().message(errno));
    return path;
}

/// Locks a folder; returns a descriptor that holds the lock, or -1.
int try_lock(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
    close(descriptor);
    return -1;
}

/// Flushes a file, so that its content is on the disk before the rename that marks it as complete.
void flush_to_disk(const fs::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
    const int reason = errno;
    if (descriptor >= 0) close(descriptor);
    if (!flushed && reason != EINVAL)
        throw io::OutputError("cannot write " + path.string() + ": " +
                              std::generic_category().message(reason));
}

void flush_folder(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) flush_to_disk(entry.path());
    flush_to_disk(folder);
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& parent, const std::string& name) {
    while (!fs::exists(path_)) {  // another process may remove it as a left-over before it is locked
        path_ = make_unique_folder(parent, name);
        lock_ = try_lock(path_);
    }
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (lock_ >= 0) close(lock_);
}

Store::Store(fs::path root) : root_(std::move(root)) {
    for (const char* kind : {"done", "failed", "tmp"}) io::make_output_folder(root_ / kind);
}

bool Store::is_done(const std::string& id, const std::string& key) const {
    const auto result = read_result(folder("done", id) / result_file);
    return result && result->key == key;
}

ScratchFolder Store::scratch(const std::string& id) const {
    return {root_ / "tmp", id};
}

void Store::commit_done(const ScratchFolder& result, const std::string& id, const std::string& key,
                        bool force) const {
    flush_folder(result.path());
    while (!move(result.path(), folder("done", id))) {
        if (!force && is_done(id, key)) break;
        discard(folder("done", id));
    }
    discard(folder("failed", id));
}

void Store::commit_failed(const ScratchFolder& result, const std::string& id, const std::string& key) const {
    if (is_done(id, key)) return;
    flush_folder(result.path());
    while (!move(result.path(), folder("failed", id))) discard(folder("failed", id));
    if (!is_done(id, key)) discard(folder("done", id));
}

/// Returns false when `to` exists already.
bool Store::move(const fs::path& from, const fs::path& to) const {
    std::error_code error;
    fs::rename(from, to, error);
    if (!error) return true;
    if (error == std::errc::directory_not_empty || error == std::errc::file_exists ||
        error == std::errc::not_a_directory)
        return false;
    throw io::OutputError("cannot make " + to.string() + ": " + error.message());
}

/// Renames the folder into tmp/ in one step, then removes it.
void Store::discard(const fs::path& folder) const {
    if (!fs::exists(folder)) return;
    const ScratchFolder aside(root_ / "tmp", folder.filename());
    std::error_code error;
    fs::rename(folder, aside.path() / "old", error);
    if (error && error != std::errc::no_such_file_or_directory)
        throw io::OutputError("cannot remove " + folder.string() + ": " + error.message());
}

void Store::remove_left_overs() const {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(root_ / "tmp", ignored)) {
        const int lock = try_lock(entry.path());
        if (lock < 0) continue;
        fs::remove_all(entry.path(), ignored);
        close(lock);
    }
}

}  // namespace flownav::regress
