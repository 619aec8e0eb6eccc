#include "flownav/io/gz_member.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace flownav::io {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

/// The content of the first member.
std::string unpacked(std::vector<std::uint8_t> member) {
    std::string text(1000, '\0');
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, 16 + MAX_WBITS), Z_OK);
    stream.next_in = member.data();
    stream.avail_in = static_cast<uInt>(member.size());
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(text.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    text.resize(stream.total_out);
    inflateEnd(&stream);
    return text;
}

TEST(GzMember, IsAWholeGzFileOfTheSameBytesEveryTime) {
    const std::string text(500, 'a');
    for (const int level : {gz_default_level, 0, 1, 9}) {
        EXPECT_EQ(unpacked(gz_member(bytes_of(text), level)), text) << level;
        EXPECT_EQ(gz_member(bytes_of(text), level), gz_member(bytes_of(text), level));
    }
    EXPECT_LT(gz_member(bytes_of(text)).size(), 100U);
    EXPECT_GT(gz_member(bytes_of(text), 0).size(), 500U);
}

TEST(GzMember, NothingIsAMemberToo) {
    EXPECT_EQ(unpacked(gz_member({})), "");
}

}  // namespace
}  // namespace flownav::io
