#pragma once
#include <mrpt/io/CStream.h>

#include <cstdint>
#include <set>
#include <vector>

#include "input_bytes.h"

namespace flownav::io {

/// Feeds MRPT's deserialization one object at a time, and keeps that object's bytes so that it can be read
/// again.
///
/// MRPT allocates whatever a stored length asks for, so that one flipped bit can ask for gigabytes. A 4-byte
/// value larger than anything the file can still hold is therefore in doubt: a stand-in is handed out
/// instead. A length shows itself because another stand-in makes the object read other pieces (trace());
/// whatever leaves the pieces alone is only a number, and settle_doubts() lets it pass as stored from then
/// on.
class ObjectStream : public mrpt::io::CStream {
  public:
    struct ParseError {
        std::uint32_t value = 0;
        std::uint64_t byte_offset = 0;
    };

    /// A place between two objects to come back to.
    struct Mark {
        InputBytes::Mark bytes;
        std::vector<std::uint8_t> ahead;  ///< what was read beyond the place
        std::uint64_t byte_offset = 0;
    };

    explicit ObjectStream(InputBytes& bytes) : bytes_(bytes) {}

    /// Forgets the bytes of the object before; the next one begins here.
    void begin_object();

    /// Reads the same object again with this stand-in for values in doubt.
    void rewind(std::uint32_t placeholder);

    void settle_doubts();

    /// Behind the object read last or, when `again`, before it.
    Mark mark(bool again) const;
    void go_to(const Mark& mark);

    /// The bytes ahead without consuming them; fewer at the end of the file.
    std::vector<std::uint8_t> peek(std::size_t count);

    const std::vector<ParseError>& parse_errors() const { return parse_errors_; }  ///< of this pass
    std::uint64_t trace() const { return trace_; }  ///< digest of the sizes of all pieces read
    bool ran_dry() const { return ran_dry_; }       ///< the object asked for bytes that are not there
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
    std::vector<std::uint8_t> object_;  ///< from the object's first byte on
    std::size_t at_ = 0;
    std::uint64_t object_offset_ = 0;
    std::uint32_t placeholder_ = 0;
    std::uint64_t trace_ = 0;
    bool ran_dry_ = false;
    std::vector<ParseError> parse_errors_;
    std::set<std::uint64_t> settled_;  ///< offsets of values that turned out to be mere numbers
};

}  // namespace flownav::io
