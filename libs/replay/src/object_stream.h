#pragma once
#include <mrpt/io/CStream.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "input_bytes.h"

namespace flownav {

/// Feeds MRPT's deserialization one object at a time, and keeps that object's bytes so that it can be read
/// twice.
///
/// MRPT allocates whatever a stored length asks for, so that one flipped bit can ask for gigabytes. A 4-byte
/// value larger than anything the file can still hold is therefore handed out as 0 in the first pass. An
/// object that nevertheless reads to its end flag only contained a number (a float, say): rewind() then lets
/// the second pass see it. One that does not was damaged.
class ObjectStream : public mrpt::io::CStream {
  public:
    struct Doubt {
        std::uint32_t value = 0;
        std::uint64_t byte_offset = 0;
    };

    explicit ObjectStream(InputBytes& bytes) : bytes_(bytes) {}

    /// Forgets the bytes of the object before; the next one begins here.
    void begin_object();

    /// Reads the same object again, this time with every value as stored.
    void rewind();

    /// The bytes ahead without consuming them; fewer at the end of the file.
    std::vector<std::uint8_t> peek(std::size_t count);

    bool ran_dry() const { return ran_dry_; }  ///< the object asked for bytes that are not there
    const std::optional<Doubt>& doubt() const { return doubt_; }  ///< first value that was replaced by 0
    std::uint64_t object_offset() const { return object_offset_; }

    size_t Read(void* target, size_t count) override;
    size_t Write(const void* source, size_t count) override;                      ///< not supported: throws
    uint64_t Seek(int64_t offset, TSeekOrigin origin = sFromBeginning) override;  ///< not supported: throws
    uint64_t getTotalBytesCount() const override { return object_offset_ + object_.size(); }
    uint64_t getPosition() const override { return object_offset_ + at_; }

  private:
    std::size_t make_available(std::size_t count);
    void hide_implausible_length(std::uint8_t* four_bytes);

    InputBytes& bytes_;
    std::vector<std::uint8_t> object_;  ///< from the object's first byte on
    std::size_t at_ = 0;
    std::uint64_t object_offset_ = 0;
    bool ran_dry_ = false;
    bool trust_ = false;
    std::optional<Doubt> doubt_;
};

}  // namespace flownav
