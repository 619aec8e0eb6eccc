#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace flownav::io {

/// The input cannot be opened or is no rawlog at all; what() names the file and the reason.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How reading a rawlog ended.
struct ReadEnd {
    enum class Kind {
        NotYet,        ///< there may be more
        Clean,         ///< the file ends where an object ends, and its gz checksum is right
        Truncated,     ///< the file ends inside an object or inside the gz stream
        Corrupt,       ///< the gz stream or an object is damaged
        UnknownClass,  ///< an object of a class this program does not know: nothing after it can be read
    };
    Kind kind = Kind::NotYet;
    std::string message;             ///< what and where, for people; empty when clean
    std::uint64_t objects_read = 0;  ///< whole objects before the end
    std::uint64_t byte_offset = 0;   ///< of the uncompressed stream, after the last whole object
};

/// Reads the observations of a rawlog one after the other, whatever its kind (observation list, sensory
/// frames, both mixed), gz or plain. Never holds more than one object of the file. Unlike MRPT's own reader
/// it tells a clean end from a cut and from damage, and checks the gz checksum. Odometry that is only
/// recorded as actions (CActionRobotMovement2D) comes as CObservationOdometry labelled ODOMETRY, integrated
/// from the origin.
class RawlogReader {
  public:
    /// Throws InputError: no such file, a folder, not readable, empty, or not a rawlog.
    explicit RawlogReader(const std::filesystem::path& file);
    ~RawlogReader();
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;

    /// The next observation, or null at the end; then end() tells why.
    mrpt::obs::CObservation::Ptr next();

    const ReadEnd& end() const;

    /// A place between two observations; about 50 kB for a gz file. Never changes: readers of the same file
    /// in several threads may share it.
    struct Mark;

    /// Where the next observation begins. After the end: where the object begins that could not be read.
    std::shared_ptr<const Mark> mark() const;

    /// Goes back, or ahead, to where a reader of the same file was. What the file has gained since is read as
    /// well, so that a reader at the end of a growing file can try again.
    void go_to(const Mark& mark);

    /// Share of the file's bytes consumed, 0..1.
    double progress() const;

    /// Folder that relative names of externally stored images refer to; it need not exist.
    const std::filesystem::path& images_directory() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace flownav::io
