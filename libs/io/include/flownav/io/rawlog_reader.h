#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "flownav/io/errors.h"

namespace flownav::io {

/// End of reading a rawlog: kind, message and position.
struct ReadEnd {
    enum class Kind {
        NotYet,        ///< more objects may follow
        Clean,         ///< the file ends where an object ends, and its gz checksum is right
        Truncated,     ///< the file ends inside an object or inside the gz stream
        Corrupt,       ///< the gz stream or an object is damaged
        UnknownClass,  ///< an object has an unknown class; the objects after it cannot be read
    };
    Kind kind = Kind::NotYet;
    std::string message;             ///< problem and place in one sentence; empty when clean
    std::uint64_t objects_read = 0;  ///< whole objects before the end
    std::uint64_t byte_offset = 0;   ///< offset in the uncompressed stream after the last whole object
};

/// Reads the observations of a rawlog of any kind (observation list, sensory frames, or both), gz or plain,
/// in order. Holds at most one object of the file. Unlike MRPT's reader it distinguishes a clean end from
/// truncation and damage, and checks the gz checksum. Odometry recorded only as actions
/// (CActionRobotMovement2D) is returned as CObservationOdometry labelled ODOMETRY, integrated from the
/// origin.
class RawlogReader {
  public:
    /// Opens `file`. Throws InputError: no such file, a folder, not readable, empty, or not a rawlog.
    explicit RawlogReader(const std::filesystem::path& file);
    ~RawlogReader();
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;

    /// Next observation; null at the end, when end() holds its kind.
    mrpt::obs::CObservation::Ptr next();

    const ReadEnd& end() const;

    /// Position between two observations; about 50 kB for a gz file. Immutable: readers of the same file in
    /// several threads may share it.
    struct Mark;

    /// Position of the next observation; after the end, position of the object that could not be read.
    std::shared_ptr<const Mark> mark() const;

    /// Moves to a position of a reader of the same file. Reads data appended to the file since, so that a
    /// reader at the end of a growing file can continue.
    void go_to(const Mark& mark);

    /// Share of the file's bytes consumed, 0..1.
    double progress() const;

    /// Folder that relative names of externally stored images refer to; it may not exist.
    const std::filesystem::path& images_directory() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace flownav::io
