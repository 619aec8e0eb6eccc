#include "input_bytes.h"

#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "flownav/io/rawlog_reader.h"

namespace flownav::io {
namespace {

constexpr std::size_t buffer_bytes = 1 << 18;
constexpr std::uint64_t deflate_ratio_max = 1032;  // output bytes per byte of a deflate stream
constexpr std::uint64_t held_back_max = 1 << 17;   // output held back in a decoder, > 2 windows

std::uint64_t checked_size(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw InputError(file.string() + ": no such file");
    if (std::filesystem::is_directory(status))
        throw InputError(file.string() + ": is a folder, not a rawlog");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(file.string() + ": is not a regular file");
    const auto size = std::filesystem::file_size(file, error);
    if (error) throw InputError(file.string() + ": cannot be read: " + error.message());
    if (size == 0)
        throw InputError(file.string() + ": is empty; the recording never got to its first object");
    return size;
}

const char* meaning_of(int result) {
    switch (result) {
        case ISAL_INVALID_BLOCK:
            return "invalid block";
        case ISAL_INVALID_SYMBOL:
            return "invalid symbol";
        case ISAL_INVALID_LOOKBACK:
            return "invalid distance";
        case ISAL_INVALID_WRAPPER:
            return "invalid header";
        case ISAL_UNSUPPORTED_METHOD:
            return "unknown compression method";
        case ISAL_INCORRECT_CHECKSUM:
            return "incorrect checksum";
        default:
            return "unknown error";
    }
}

bool is_gz(const std::uint8_t* bytes, std::size_t count) {
    return count >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

}  // namespace

struct InputBytes::Inflater {
    inflate_state stream;
    bool inside_member = true;
    int failure = ISAL_DECOMP_OK;  ///< error of the decoder, reported after the bytes decoded before it

    Inflater() {
        isal_inflate_init(&stream);
        stream.crc_flag = ISAL_GZIP;
    }
};

InputBytes::InputBytes(const std::filesystem::path& file)
    : file_size_(checked_size(file)), buffer_(buffer_bytes) {
    errno = 0;
    file_.reset(std::fopen(file.c_str(), "rbe"));
    if (!file_)
        throw InputError(file.string() + ": cannot be read: " + std::generic_category().message(errno));
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    refill();
    if (is_gz(buffer_.data(), filled_)) inflater_ = std::make_unique<Inflater>();
}

InputBytes::~InputBytes() = default;

InputBytes::Mark InputBytes::mark() const {
    Mark mark;
    mark.file_offset = taken_ - (filled_ - at_);
    if (inflater_) mark.inflater = std::make_shared<const Inflater>(*inflater_);
    return mark;
}

void InputBytes::go_to(const Mark& mark) {
    inflater_ = mark.inflater ? std::make_unique<Inflater>(*mark.inflater) : nullptr;
    at_ = filled_ = 0;
    file_over_ = false;
    taken_ = mark.file_offset;
    stop(State::Good, "");
    errno = 0;
    bool sought = fseeko(file_.get(), 0, SEEK_END) == 0;
    const off_t size = ftello(file_.get());
    sought = sought && size >= 0 && fseeko(file_.get(), static_cast<off_t>(mark.file_offset), SEEK_SET) == 0;
    if (sought) {
        file_size_ = static_cast<std::uint64_t>(size);
    } else {
        stop(State::Corrupt, "the disk cannot be read: " + std::generic_category().message(errno));
    }
}

void InputBytes::refill() {
    // A gz member's magic may straddle the end of the buffer, so unused bytes are kept.
    std::memmove(buffer_.data(), buffer_.data() + at_, filled_ - at_);
    filled_ -= at_;
    at_ = 0;
    errno = 0;
    const std::size_t got = std::fread(buffer_.data() + filled_, 1, buffer_.size() - filled_, file_.get());
    filled_ += got;
    taken_ += got;
    if (got > 0) return;
    file_over_ = true;
    if (std::ferror(file_.get()) != 0) {
        stop(State::Corrupt, "the disk cannot be read: " + std::generic_category().message(errno));
    }
}

void InputBytes::stop(State state, const std::string& problem) {
    state_ = state;
    problem_ = problem;
}

std::size_t InputBytes::read(std::uint8_t* target, std::size_t count) {
    std::size_t done = 0;
    while (done < count && state_ == State::Good) {
        const std::size_t got =
            inflater_ ? inflate_some(target + done, count - done) : copy_plain(target + done, count - done);
        done += got;
    }
    return done;
}

std::size_t InputBytes::copy_plain(std::uint8_t* target, std::size_t count) {
    if (at_ == filled_) refill();
    const std::size_t n = std::min(count, filled_ - at_);
    std::memcpy(target, buffer_.data() + at_, n);
    at_ += n;
    if (n == 0 && state_ == State::Good) stop(State::End, "");
    return n;
}

std::size_t InputBytes::inflate_some(std::uint8_t* target, std::size_t count) {
    if (!inflater_->inside_member) start_next_member();
    if (at_ == filled_ && !file_over_) refill();
    if (state_ != State::Good) return 0;
    inflate_state& z = inflater_->stream;
    const std::size_t wanted = std::min<std::size_t>(count, 1U << 30);
    z.next_in = buffer_.data() + at_;
    z.avail_in = static_cast<std::uint32_t>(filled_ - at_);
    z.next_out = target;
    z.avail_out = static_cast<std::uint32_t>(wanted);
    if (inflater_->failure == ISAL_DECOMP_OK) inflater_->failure = std::min(0, isal_inflate(&z));
    at_ = filled_ - z.avail_in;
    const std::size_t made = wanted - z.avail_out;
    if (inflater_->failure != ISAL_DECOMP_OK) {
        stop(State::Corrupt,
             std::string("the gz stream is damaged (") + meaning_of(inflater_->failure) + ')');
    } else if (z.block_state == ISAL_BLOCK_FINISH) {
        inflater_->inside_member = false;
    } else if (made == 0 && file_over_ && at_ == filled_) {
        stop(State::Truncated, "the gz stream stops before its end");
    }
    return made;
}

void InputBytes::start_next_member() {
    if (filled_ - at_ < 2 && !file_over_) refill();
    if (state_ != State::Good) return;
    if (at_ == filled_) {
        stop(State::End, "");
    } else if (is_gz(buffer_.data() + at_, filled_ - at_)) {
        isal_inflate_reset(&inflater_->stream);
        inflater_->inside_member = true;
    } else {
        stop(State::Corrupt, "the gz stream is followed by bytes that do not belong to it");
    }
}

std::uint64_t InputBytes::upper_bound() const {
    if (state_ != State::Good) return 0;
    const std::uint64_t left = (file_size_ > taken_ ? file_size_ - taken_ : 0) + (filled_ - at_);
    return inflater_ ? left * deflate_ratio_max + held_back_max : left;
}

double InputBytes::progress() const {
    const auto used = static_cast<double>(taken_ - (filled_ - at_));
    return file_size_ == 0 ? 1.0 : std::min(1.0, used / static_cast<double>(file_size_));
}

}  // namespace flownav::io
