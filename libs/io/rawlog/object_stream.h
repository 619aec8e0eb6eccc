#pragma once
#include <mrpt/io/CStream.h>

#include <cstdint>
#include <set>
#include <vector>

#include "input_bytes.h"

namespace flownav::io {

/// Feeds MRPT's deserialization one object at a time, and keeps the object's bytes so that it can be read
/// again.
///
/// MRPT allocates memory for any stored length, so one flipped bit can ask for gigabytes. A 4-byte value
/// larger than the rest of the file is therefore recorded as a parse error and replaced by a placeholder. If
/// another placeholder changes the sizes of the pieces read (trace()), the value is a length. Otherwise it is
/// a plain number, and after settle_doubts() it is delivered as stored.
class ObjectStream : public mrpt::io::CStream {
  public:
    struct ParseError {
        std::uint32_t value = 0;
        std::uint64_t byte_offset = 0;
    };

    /// Position between two objects, for go_to().
    struct Mark {
        InputBytes::Mark bytes;
        std::vector<std::uint8_t> ahead;  ///< bytes read beyond the position
        std::uint64_t byte_offset = 0;
    };

    explicit ObjectStream(InputBytes& bytes) : bytes_(bytes) {}

    /// Discards the bytes of the previous object and begins the next one.
    void begin_object();

    /// Restarts the same object with this placeholder for doubtful values.
    void rewind(std::uint32_t placeholder);

    void settle_doubts();

    /// Position after the last object read or, when `again`, before it.
    Mark mark(bool again) const;
    void go_to(const Mark& mark);

    /// Returns the next `count` bytes without consuming them; fewer at the end of the file.
    std::vector<std::uint8_t> peek(std::size_t count);

    const std::vector<ParseError>& parse_errors() const { return parse_errors_; }  ///< of this pass
    std::uint64_t trace() const { return trace_; }  ///< hash of the sizes of all pieces read
    bool ran_dry() const { return ran_dry_; }       ///< the object needed more bytes than the file has
    std::uint64_t object_offset() const { return object_offset_; }

    size_t Read(void* target, size_t count) override;
    size_t Write(const void* source, size_t count) override;                      ///< not supported: throws
    uint64_t Seek(int64_t offset, TSeekOrigin origin = sFromBeginning) override;  ///< not supported: throws
    uint64_t getTotalBytesCount() const override { return object_offset_ + object_.size(); }
    uint64_t getPosition() const override { return object_offset_ + at_; }

  private:
    std::size_t make_available(std::size_t count);
    void replace_if_in_doubt(std::uint8_t* four_bytes);

    InputBytes& bytes_;
    std::vector<std::uint8_t> object_;  ///< bytes from the object's first byte on
    std::size_t at_ = 0;
    std::uint64_t object_offset_ = 0;
    std::uint32_t placeholder_ = 0;
    std::uint64_t trace_ = 0;
    bool ran_dry_ = false;
    std::vector<ParseError> parse_errors_;
    std::set<std::uint64_t> settled_;  ///< offsets of values known to be plain numbers
};

}  // namespace flownav::io
