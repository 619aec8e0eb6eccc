#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/io/field_source.h"
#include "flownav/pipeline/pipeline.h"
#include "frame.h"

namespace flownav::view {

/// State of a Runner between two fields. Immutable; threads may share it.
struct Checkpoint {
    std::size_t next_index = 0;  ///< index of the next field
    std::shared_ptr<const io::RawlogReader::Mark> place;
    io::FieldSource source;
    pipeline::State state;
    Frame frame;

    /// Approximate memory use.
    std::size_t bytes() const;
};

/// Runs a rawlog through the pipeline field by field with the results of flownav-replay, and can resume from
/// a checkpoint.
class Runner {
  public:
    /// Throws InputError when the file cannot be read.
    Runner(const std::filesystem::path& file, const config::Config& config);

    /// Processes the next field. Returns false at the end of the readable data. Throws ConfigError when the
    /// first images cannot be used; later ones end the drive, see stop_reason().
    bool advance();

    const Frame& frame() const { return frame_; }
    std::size_t next_index() const { return next_index_; }

    /// Odometry and ground truth before the field, read by the last advance().
    const std::vector<io::PoseSample>& poses() const { return poses_; }

    std::shared_ptr<const Checkpoint> checkpoint() const;

    /// Resumes from a checkpoint of the same file and configuration.
    void resume(const Checkpoint& checkpoint);

    /// Resumes at the place of a checkpoint with a new pipeline state.
    void resume_afresh(const Checkpoint& checkpoint, const config::Config& config);

    /// Continues reading at the end of a file that may have grown.
    void retry();

    const io::ReadEnd& end() const { return reader_->end(); }
    const std::string& stop_reason() const { return stop_reason_; }
    const io::InputCounts& counts() const { return source_->counts(); }
    double progress() const { return reader_->progress(); }

  private:
    std::optional<io::ReplayEvent> next_event();
    void take(const Field& field);

    std::unique_ptr<io::RawlogReader> reader_;
    std::optional<io::FieldSource> source_;
    pipeline::State state_;
    Frame frame_;
    std::size_t next_index_ = 0;
    std::vector<io::PoseSample> poses_;
    std::string stop_reason_;
};

}  // namespace flownav::view
