#include "flownav/io/gz_member.h"

#include <zlib.h>

#include <stdexcept>

namespace flownav::io {

namespace {

constexpr int gzip_window_bits = 15 + 16;
constexpr int memory_level = 8;

/// A deflate stream that frees itself.
struct Deflater {
    explicit Deflater(int level) {
        if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window_bits, memory_level, Z_DEFAULT_STRATEGY) !=
            Z_OK)
            throw std::runtime_error("gz compression cannot be set up: too little memory");
    }
    ~Deflater() { deflateEnd(&stream); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    z_stream stream{};
};

}  // namespace

std::vector<std::uint8_t> gz_member(const std::vector<std::uint8_t>& bytes, int level) {
    Deflater deflater(level);
    z_stream& stream = deflater.stream;
    std::vector<std::uint8_t> member(deflateBound(&stream, bytes.size()));
    stream.next_in = const_cast<Bytef*>(bytes.data());  // zlib only reads it
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = member.data();
    stream.avail_out = static_cast<uInt>(member.size());
    if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("gz compression failed");
    member.resize(stream.total_out);
    return member;
}

}  // namespace flownav::io
