#include "object_stream.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace flownav::io {
namespace {

constexpr std::uint32_t first_placeholder = 1;
constexpr std::uint64_t always_accepted_length = 1U << 20;
constexpr std::uint64_t length_max = 1U << 28;  // elements; pictures and point clouds have fewer
constexpr std::size_t growth_step = 1U << 20;

/// True for a negated size, which MRPT stores for raw colour pictures.
bool is_negated_size(std::uint32_t value) {
    const auto number = static_cast<std::int32_t>(value);
    return number >= -65536 && number <= -8;
}

}  // namespace

void ObjectStream::begin_object() {
    object_offset_ += at_;
    object_.erase(object_.begin(), object_.begin() + static_cast<std::ptrdiff_t>(at_));
    settled_.clear();
    rewind(first_placeholder);
}

void ObjectStream::rewind(std::uint32_t placeholder) {
    at_ = 0;
    trace_ = 0;
    ran_dry_ = false;
    parse_errors_.clear();
    placeholder_ = placeholder;
}

void ObjectStream::settle_doubts() {
    for (const ParseError& parse_error : parse_errors_) settled_.insert(parse_error.byte_offset);
}

ObjectStream::Mark ObjectStream::mark(bool again) const {
    const std::size_t from = again ? 0 : at_;
    const auto begin = object_.begin() + static_cast<std::ptrdiff_t>(from);
    return {bytes_.mark(), {begin, object_.end()}, object_offset_ + from};
}

void ObjectStream::go_to(const Mark& mark) {
    bytes_.go_to(mark.bytes);
    object_ = mark.ahead;
    object_offset_ = mark.byte_offset;
    settled_.clear();
    rewind(first_placeholder);
}

std::size_t ObjectStream::make_available(std::size_t count) {
    // Grows in steps, so that a damaged count does not allocate more than the file delivers.
    while (object_.size() - at_ < count) {
        const std::size_t old = object_.size();
        const std::size_t step = std::min(count - (old - at_), growth_step);
        object_.resize(old + step);
        const std::size_t got = bytes_.read(object_.data() + old, step);
        object_.resize(old + got);
        if (got < step) break;
    }
    return std::min(count, object_.size() - at_);
}

std::vector<std::uint8_t> ObjectStream::peek(std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(make_available(count));
    const auto first = object_.begin() + static_cast<std::ptrdiff_t>(at_);
    return {first, first + n};
}

size_t ObjectStream::Read(void* target, size_t count) {
    trace_ = (trace_ ^ count) * 0x100000001b3U + 1;
    const std::size_t n = make_available(count);
    if (n < count) {
        ran_dry_ = true;
        throw std::runtime_error("the object needs more bytes than the file has");
    }
    std::memcpy(target, object_.data() + at_, n);
    if (count == 4) replace_if_in_doubt(static_cast<std::uint8_t*>(target));
    at_ += n;
    return n;
}

void ObjectStream::replace_if_in_doubt(std::uint8_t* four_bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, four_bytes, 4);
    const std::uint64_t left = object_.size() - at_ + bytes_.upper_bound();
    const std::uint64_t limit = std::clamp(left, always_accepted_length, length_max);
    if (value <= limit || is_negated_size(value) || settled_.count(getPosition()) > 0) return;
    parse_errors_.push_back({value, getPosition()});
    std::memcpy(four_bytes, &placeholder_, 4);
}

size_t ObjectStream::Write(const void* /*source*/, size_t /*count*/) {
    throw std::logic_error("ObjectStream cannot write");
}

uint64_t ObjectStream::Seek(int64_t /*offset*/, TSeekOrigin /*origin*/) {
    throw std::logic_error("ObjectStream cannot seek");
}

}  // namespace flownav::io
