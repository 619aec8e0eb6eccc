#include "flownav/io/decode_ahead.h"

#include <chrono>
#include <utility>

namespace flownav::io {

namespace {

constexpr std::size_t events_ahead = 8;  // 2 MB of PAL fields, 66 MB of 4K fields

}  // namespace

Decoded decode_next(FieldSource& source, const RawlogReader& reader) {
    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    Decoded decoded;
    decoded.event = source.next();
    decoded.progress = reader.progress();
    decoded.decode_s = std::chrono::duration<double>(Clock::now() - began).count();
    return decoded;
}

DecodeAhead::DecodeAhead(FieldSource& source, const RawlogReader& reader)
    : queue_(events_ahead), thread_([this, &source, &reader] { run(source, reader); }) {}

DecodeAhead::~DecodeAhead() {
    queue_.stop();
    thread_.join();
}

Decoded DecodeAhead::next() {
    return queue_.pop().value_or(Decoded{});
}

void DecodeAhead::run(FieldSource& source, const RawlogReader& reader) {
    try {
        bool more = true;
        while (more) {
            Decoded decoded = decode_next(source, reader);
            more = decoded.event.has_value();
            more = queue_.push(std::move(decoded)) && more;
        }
        queue_.close();
    } catch (...) {
        queue_.close(std::current_exception());
    }
}

}  // namespace flownav::io
