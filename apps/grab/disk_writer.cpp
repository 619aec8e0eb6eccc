#include "disk_writer.h"

#include <algorithm>

namespace flownav {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto tick = std::chrono::milliseconds(10);

/// Limit of a member's uncompressed size: even an incompressible member fits into a file.
std::uint64_t longest_member(const RecordingOptions& options) {
    constexpr std::uint64_t bytes = 4U << 20;
    return options.max_bytes > 0 ? std::min(bytes, options.max_bytes / 2) : bytes;
}

}  // namespace

DiskWriter::DiskWriter(RecordingOptions options, std::uint64_t queue_bytes_max)
    : queue_bytes_max_(queue_bytes_max),
      member_bytes_max_(longest_member(options)),
      recording_(std::move(options)),
      files_(recording_.files()),
      thread_([this] { run(); }) {}

DiskWriter::~DiskWriter() {
    finish();
}

bool DiskWriter::fits(const QueuedObject& object) const {
    // An empty queue accepts one object of any size.
    return window_.bytes() == 0 || window_.bytes() + object.bytes.size() <= queue_bytes_max_;
}

void DiskWriter::put(QueuedObject object) {
    const std::lock_guard lock(mutex_);
    if (!failure_.empty()) {
        ++counts_.lost;
    } else if (!fits(object)) {
        ++counts_.dropped[object.label];
    } else {
        window_.push(std::move(object), Clock::now());
    }
}

void DiskWriter::put_when_there_is_room(QueuedObject object) {
    {
        std::unique_lock lock(mutex_);
        room_.wait(lock, [&] { return fits(object) || !failure_.empty(); });
    }
    put(std::move(object));
}

void DiskWriter::finish() {
    {
        const std::lock_guard lock(mutex_);
        finishing_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

WriterCounts DiskWriter::counts() const {
    const std::lock_guard lock(mutex_);
    WriterCounts counts = counts_;
    counts.late = window_.late();
    counts.queue_bytes = window_.bytes();
    return counts;
}

std::string DiskWriter::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

std::vector<std::filesystem::path> DiskWriter::files() const {
    const std::lock_guard lock(mutex_);
    return files_;
}

void DiskWriter::run() {
    try {
        write_until_finished();
        recording_.close();
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        failure_ = error.what();
        counts_.lost += taken_ + window_.take_all().size();
        for (const auto& [label, count] : counts_.written) counts_.lost -= count;
    }
    room_.notify_all();
}

void DiskWriter::write_until_finished() {
    for (bool last = false; !last;) {
        std::vector<QueuedObject> objects;
        {
            std::unique_lock lock(mutex_);
            changed_.wait_for(lock, tick, [this] { return finishing_; });
            last = finishing_;
            objects = last ? window_.take_all() : window_.take_ripe(Clock::now());
            taken_ += objects.size();
        }
        room_.notify_all();
        write(objects);
        if (last || Clock::now() - member_begin_ >= member_period) flush();
    }
}

void DiskWriter::write(const std::vector<QueuedObject>& objects) {
    for (const QueuedObject& object : objects) {
        if (recording_.pending_bytes() + object.bytes.size() > member_bytes_max_) flush();
        if (recording_.pending_bytes() == 0) member_begin_ = Clock::now();
        ++in_member_[object.label];
        recording_.add(object.bytes);
    }
}

void DiskWriter::flush() {
    recording_.flush();
    const std::lock_guard lock(mutex_);
    for (const auto& [label, count] : in_member_) counts_.written[label] += count;
    in_member_.clear();
    counts_.file_bytes = recording_.written_bytes();
    files_ = recording_.files();
}

}  // namespace flownav
